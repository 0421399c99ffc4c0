#pragma once
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/servo/snapshot.h"

namespace underact::record {

/// A session as CSV: a header with units, a row a tick, lengths mm, angles rad, forces N, time s; numbers read back to
/// the same double. Not for the servo thread. Errors (a full disk) are kept and told by close().
class CsvWriter {
 public:
  /// Problems: the file cannot be made.
  static Result<CsvWriter> open(const std::string& path);
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
  CsvWriter(std::FILE* file, std::string path) : file_(file), path_(std::move(path)) {}
  void write(std::string_view text);
  std::unique_ptr<std::FILE, Closer> file_;
  std::string path_;
  int error_ = 0;  // errno of the first failure
};

}  // namespace underact::record
