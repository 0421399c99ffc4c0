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

/// The finished cells of a sweep in progress, in a file beside the result: a line for each cell, with a checksum,
/// handed to the system as soon as the cell is done. If the program is killed, only the cells that were running are
/// lost; after a power cut, also what the system had not written. One program writes it at a time.
class Journal {
 public:
  /// Opens the journal of the result at `result`, or begins one. Incomplete or damaged lines are left out, and their
  /// cells run again. Problems: another program writes it; it is of another sweep; the file cannot be read or written.
  static Result<Journal> open(const Sweep& sweep, const std::string& result);

  /// Adds the row of rowOf(). Problems: the disk is full.
  Problems add(std::size_t cell, const std::string& row);
  /// The finished cells, those read and those added.
  const Rows& rows() const { return rows_; }
  const std::string& path() const { return path_; }
  /// Removes the file, once the result is written.
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

/// The path of the journal of a result.
std::string journalOf(const std::string& result);

}  // namespace underact::sweep
