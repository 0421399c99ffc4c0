#pragma once
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/record/session.h"
#include "core/servo/snapshot.h"
#include "core/system/private_file.h"

namespace underact::record {

/// A session as CSV: a header with units, a row a tick, lengths mm, angles rad, forces N, time s; numbers read back to
/// the same double. Not for the servo thread. Errors (a full disk) are kept and told by close().
class CsvWriter {
 public:
  /// Over what is there, also where that is a pipe or the standard output: an export. A file that it makes is its
  /// owner's alone; one that was there keeps who may read it. Problems: it cannot be made.
  static Result<CsvWriter> open(const std::string& path);
  /// A file of its own that its owner alone may read and write: a recording. Problems: those of checkNew(); it cannot
  /// be made.
  static Result<CsvWriter> create(const std::string& path, system::Existing existing);
  /// After a failure nothing more is written.
  void add(const servo::TickRecord& record);
  /// Something could not be written; the sentence comes with close().
  bool hasFailed() const { return error_ != 0; }
  /// Flushes and closes. Problems: something could not be written; what is there is whole up to a line.
  Problems close();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  /// made: where it is none, errno says why.
  static Result<CsvWriter> into(system::Descriptor made, const std::string& path);
  CsvWriter(std::FILE* file, std::string path) : file_(file), path_(std::move(path)) {}
  void write(std::string_view text);
  std::unique_ptr<std::FILE, Closer> file_;
  std::string path_;
  int error_ = 0;  // errno of the first failure
};

/// What came of an export.
struct CsvExport {
  std::int64_t rows = 0;     // written
  std::int64_t missing = 0;  // that are damaged in the session
  bool is_stopped = false;   // before its end, as was asked
  Problems unread;           // why no more was read
  Problems unwritten;        // what is there is whole up to a line
  /// Whether every tick of the session was written.
  bool isWhole() const { return missing == 0 && !is_stopped && unread.empty() && unwritten.empty(); }
};

/// Writes the ticks of a session as CSV and closes the file. goes_on: asked after each block, told the share that is
/// done; false ends the export there.
CsvExport exportCsv(Session& session, CsvWriter& csv, const std::function<bool(double share)>& goes_on);

}  // namespace underact::record
