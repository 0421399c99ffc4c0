#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/helper/child.h"

namespace underact::helper {

/// Limits of one answer: processor time and total time, s, on a busy machine and a slow disk, and its length.
struct Bounds {
  double max_cpu_s = 2.0, max_time_s = 30.0;
  std::size_t max_bytes = std::size_t{1} << 20;
};

/// A helper that answers one question after another. One thread at a time. After a question without an answer it has
/// ended, and no further one is answered.
class HelperConnection {
 public:
  HelperConnection() = default;
  /// file_fd: becomes the helper's descriptor kFile; stays the caller's.
  HelperConnection(const std::string& program, int file_fd);

  /// Sends the question and gives the answer, before which the helper sends its length: eight bytes. None: ending()
  /// says why.
  std::optional<std::vector<std::byte>> ask(std::span<const std::byte> question, const Bounds& bounds);
  Ending ending() const { return ending_; }
  int code() const { return code_; }  // exit status, the signal that ended it, or errno

 private:
  bool send(std::span<const std::byte> bytes);
  bool receive(std::span<std::byte> bytes, const Bounds& bounds, double from_cpu_s, double until_s);
  bool fail(Ending ending);

  Child child_;
  system::Descriptor here_;
  Ending ending_ = Ending::NotStarted;
  int code_ = 0;
};

/// The helper's side, on its standard input and output. The next question, of exactly that many bytes; false: there are
/// no more.
bool nextQuestion(std::span<std::byte> question);
/// Sends an answer. false: it is no longer read.
bool answer(std::span<const std::span<const std::byte>> parts);

}  // namespace underact::helper
