#pragma once
#include <ostream>
#include <streambuf>
#include <string>

namespace underact::cli {

/// A stream that leads to another one and shows control characters as printed() does, except line breaks and tabs, so
/// that nothing that a command prints can operate the terminal. It is the net: a stranger's words go through printed()
/// where they are inserted, so that no line break of theirs begins a line. A '\r' passes where it is all that is
/// written, for a line of progress.
class PrintedStream : private std::streambuf, public std::ostream {
 public:
  /// to: outlives it. What is written is at once in the buffer of `to`.
  explicit PrintedStream(std::ostream& to) : std::ostream(this), to_(to) {}

 private:
  std::streambuf::int_type overflow(std::streambuf::int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;
  int sync() override { return to_.flush() ? 0 : -1; }

  std::ostream& to_;
};

}  // namespace underact::cli
