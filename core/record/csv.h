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

/// A session as CSV: a header with units, a row for each tick, lengths mm, angles rad, forces N, time s; numbers read
/// back to the same double. Not for the servo thread. Errors (a full disk) are kept and reported by close().
class CsvWriter {
 public:
  /// For a recording or an export: a new file that its owner alone may read and write, or with ReplaceFile with the
  /// rights of the one that was there. Problems: those of checkNew(); it cannot be made.
  static Result<CsvWriter> create(const std::string& path, system::Existing existing);
  /// To the standard output.
  static Result<CsvWriter> toOutput();
  /// Whether there are columns for joints beyond the sixth, to be told before the first row; else as the arm of the
  /// first row has them.
  void setMoreJoints(bool on) { more_joints_ = on; }
  /// Writes a row. After a failure nothing more is written.
  void add(const servo::TickRecord& record);
  /// Whether something could not be written; close() says why.
  bool hasFailed() const { return error_ != 0; }
  /// Flushes and closes. Problems: something could not be written; the file ends with a complete line.
  Problems close();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  /// made: where it is none, errno says why.
  static Result<CsvWriter> into(system::Descriptor made, const std::string& path);
  CsvWriter(std::FILE* file, std::string path) : file_(file), path_(std::move(path)) {}
  void write(std::string_view text);
  void writeHeader();
  std::unique_ptr<std::FILE, Closer> file_;
  std::string path_;
  int error_ = 0;  // errno of the first failure
  bool more_joints_ = false, has_header_ = false;
};

/// The result of an export.
struct CsvExport {
  std::int64_t rows = 0;     // written
  std::int64_t missing = 0;  // rows that are damaged in the session
  bool is_stopped = false;   // ended early by goes_on
  Problems unread;           // why not all was read
  Problems unwritten;        // what is there is whole up to a line
  /// Whether every tick of the session was written.
  bool isWhole() const { return missing == 0 && !is_stopped && unread.empty() && unwritten.empty(); }
};

/// Writes the ticks of a session as CSV and closes the file. goes_on: called after each block with the share that is
/// done; false ends the export there.
CsvExport exportCsv(Session& session, CsvWriter& csv, const std::function<bool(double share)>& goes_on);

}  // namespace underact::record
