#include "core/helper/run.h"

#include <cerrno>
#include <chrono>
#include <span>

#include "core/system/channel.h"
#include "core/system/file.h"

namespace underact::helper {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPoll_ms = 10;  // between checks of cancellation and time limits

/// Reads the output of the program, until it ends or has to end.
class Listening {
 public:
  Listening(const HelperCall& errand, const TaskMonitor& monitor, Answer& answer)
      : errand_(errand), watch_(monitor), answer_(answer), block_(system::kAtOnce) {}

  Ending until(int fd, const Child& child) {
    const Clock::time_point start = Clock::now();
    for (;;) {
      if (watch_.isCancelled()) return Ending::Cancelled;
      const double time_s = std::chrono::duration<double>(Clock::now() - start).count();
      if (child.cpuSoFar_s() > errand_.max_cpu_s) return Ending::TookTooLong;
      if (time_s > errand_.max_time_s) return Ending::Waited;
      if (!system::waitToRead(fd, kPoll_ms)) continue;
      const std::ptrdiff_t count = system::readSome(fd, block_);
      if (count == 0) return Ending::Exited;
      if (count < 0) return Ending::Crashed;
      take(std::span(block_).first(static_cast<std::size_t>(count)));
      if (answer_.output.size() > errand_.max_output) return Ending::WroteTooMuch;
    }
  }

 private:
  void take(std::span<const std::byte> bytes) {
    while (answer_.output.empty() && !bytes.empty()) {
      const auto percent = std::to_integer<unsigned char>(bytes.front());
      if (percent == 0 || percent > kMaxProgress) break;
      if (errand_.progress) errand_.progress(percent);
      bytes = bytes.subspan(1);
    }
    answer_.output.insert(answer_.output.end(), bytes.begin(), bytes.end());
  }
  const HelperCall& errand_;
  const TaskMonitor& watch_;
  Answer& answer_;
  std::vector<std::byte> block_;
};

}  // namespace

Answer run(const HelperCall& errand, const TaskMonitor& monitor) {
  Answer answer;
  system::Pipe pipe = system::makePipe(4 * system::kAtOnce);
  Child child;
  if (pipe.reads.isOpen())
    child = Child({.program = errand.program,
                   .argument = errand.argument,
                   .input_fd = errand.input_fd,
                   .output_fd = pipe.writes.number()});
  if (!child.runs()) {
    answer.code = pipe.reads.isOpen() ? child.error() : errno;
    return answer;
  }
  pipe.writes.close();
  const Ending ending = Listening(errand, monitor, answer).until(pipe.reads.number(), child);
  pipe.reads.close();
  answer.ending = child.end(ending);
  answer.code = child.code();
  answer.cpu_s = child.cpu_s();
  return answer;
}

}  // namespace underact::helper
