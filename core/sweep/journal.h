#pragma once
#include <cstddef>
#include <map>
#include <string>

#include "core/base/result.h"
#include "core/sweep/sweep.h"
#include "core/system/descriptor.h"

namespace underact::sweep {

/// The rows of finished cells, by cell.
using Rows = std::map<std::size_t, std::string>;

/// The finished cells of a sweep that is not at its end, in a file beside the result: a line a cell, with a checksum,
/// given to the system as soon as the cell is done. A kill at any moment costs the cells that were running; a power cut
/// may cost what the system had not written. One program writes it at a time.
class Journal {
 public:
  /// Opens the journal of the result at `result`, or begins one. Lines that are torn or damaged are left out, and their
  /// cells run again. Problems: another program writes it; it is of another sweep; the file cannot be read or written.
  static Result<Journal> open(const Sweep& sweep, const std::string& result);

  /// The line of rowOf(). Problems: the disk takes no more.
  Problems add(std::size_t cell, const std::string& row);
  /// All that is done, as read and as added.
  const Rows& rows() const { return rows_; }
  const std::string& path() const { return path_; }
  /// The result is written, so that nobody needs it any more.
  void remove();

 private:
  Journal(std::string path, std::string fingerprint, system::Descriptor file);
  Problems read(const Sweep& sweep);
  Problems write(const std::string& line);

  std::string path_;
  std::string fingerprint_;
  system::Descriptor file_;
  Rows rows_;
};

/// The journal's file of a result.
std::string journalOf(const std::string& result);

}  // namespace underact::sweep
