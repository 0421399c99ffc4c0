#include "core/helper/run.h"

#if defined(__linux__)
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <span>

namespace underact::helper {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLook_ms = 10;  // how often cancel and the times are looked at

/// Takes what the program writes, until it ends or must end.
class Listening {
 public:
  Listening(const Errand& errand, const Watch& watch, Answer& answer)
      : errand_(errand), watch_(watch), answer_(answer), block_(kBlock) {}

  Ending until(int fd, const Child& child) {
    const Clock::time_point start = Clock::now();
    pollfd output{fd, POLLIN, 0};
    for (;;) {
      if (watch_.isCancelled()) return Ending::Cancelled;
      const double time_s = std::chrono::duration<double>(Clock::now() - start).count();
      if (child.cpuSoFar_s() > errand_.most_cpu_s) return Ending::TookTooLong;
      if (time_s > errand_.most_time_s) return Ending::Waited;
      if (::poll(&output, 1, kLook_ms) <= 0) continue;
      const ssize_t count = ::read(fd, block_.data(), block_.size());
      if (count == 0) return Ending::Exited;
      if (count < 0 && errno != EINTR) return Ending::Crashed;
      if (count > 0) take({block_.data(), static_cast<std::size_t>(count)});
      if (answer_.output.size() > errand_.most_output) return Ending::WroteTooMuch;
    }
  }

 private:
  void take(std::span<const std::byte> bytes) {
    while (answer_.output.empty() && !bytes.empty()) {
      const auto percent = std::to_integer<unsigned char>(bytes.front());
      if (percent == 0 || percent > kMostProgress) break;
      if (errand_.progress) errand_.progress(percent);
      bytes = bytes.subspan(1);
    }
    answer_.output.insert(answer_.output.end(), bytes.begin(), bytes.end());
  }
  const Errand& errand_;
  const Watch& watch_;
  Answer& answer_;
  std::vector<std::byte> block_;
};

}  // namespace

Answer run(const Errand& errand, const Watch& watch) {
  Answer answer;
  std::array<int, 2> pipe{-1, -1};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    answer.code = errno;
    return answer;
  }
  ::fcntl(pipe[0], F_SETPIPE_SZ, static_cast<int>(4 * kBlock));
  Child child(
      {.program = errand.program, .argument = errand.argument, .input_fd = errand.input_fd, .output_fd = pipe[1]});
  ::close(pipe[1]);
  if (!child.runs()) {
    ::close(pipe[0]);
    answer.code = child.error();
    return answer;
  }
  const Ending ending = Listening(errand, watch, answer).until(pipe[0], child);
  ::close(pipe[0]);
  answer.ending = child.end(ending);
  answer.code = child.code();
  answer.cpu_s = child.cpu_s();
  return answer;
}

}  // namespace underact::helper

#else

namespace underact::helper {

Answer run(const Errand&, const Watch&) {
  return {};
}

}  // namespace underact::helper

#endif
