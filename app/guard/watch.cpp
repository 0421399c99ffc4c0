#include "app/guard/watch.h"

#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <ctime>
#include <string_view>

#include "core/servo/guard_line.h"

namespace underact::guard {
namespace {

constexpr int kLooksInLimit = 5;
// The last word is said more than once: a report can be lost on its way, and a tick that was at work when the program
// died may still come after the first.
constexpr int kTimes = 5;
constexpr int kBetween_ms = 2;

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

void say(int device_fd, const std::string& word) {
  [[maybe_unused]] const ssize_t written = ::write(device_fd, word.data(), word.size());
}

/// The program is gone.
int sayLast(int device_fd, const std::string& word) {
  for (int time = 0; time < kTimes; ++time) {
    say(device_fd, word);
    ::poll(nullptr, 0, kBetween_ms);
  }
  return 1;
}

}  // namespace

std::optional<Duty> readDuty(int argc, const char* const* argv) {
  if (argc != 3) return {};
  Duty duty;
  const std::string_view limit(argv[1]), hex(argv[2]);
  const auto read = std::from_chars(limit.data(), limit.data() + limit.size(), duty.limit_ns);
  if (read.ec != std::errc() || read.ptr != limit.data() + limit.size() || duty.limit_ns <= 0) return {};
  if (hex.empty() || hex.size() % 2 != 0) return {};
  for (std::size_t at = 0; at < hex.size(); at += 2) {
    unsigned value = 0;
    const auto byte = std::from_chars(hex.data() + at, hex.data() + at + 2, value, 16);
    if (byte.ec != std::errc() || byte.ptr != hex.data() + at + 2) return {};
    duty.word += static_cast<char>(value);
  }
  return duty;
}

int watch(const Duty& duty) {
  void* memory = ::mmap(nullptr, sizeof(servo::GuardLine), PROT_READ | PROT_WRITE, MAP_SHARED, servo::kGuardLineFd, 0);
  if (memory == MAP_FAILED) return 2;
  return watch(duty, *static_cast<servo::GuardLine*>(memory), servo::kGuardLifeFd, servo::kGuardDeviceFd);
}

int watch(const Duty& duty, servo::GuardLine& line, int life_fd, int device_fd) {
  const int look_ms = static_cast<int>(std::clamp<std::int64_t>(duty.limit_ns / kLooksInLimit / 1'000'000, 1, 1000));
  std::int64_t seen = line.beats.load(std::memory_order_relaxed), seen_ns = now_ns();
  pollfd life{life_fd, POLLIN, 0};
  for (;;) {
    if (::poll(&life, 1, look_ms) > 0) return line.farewell == 0 ? sayLast(device_fd, duty.word) : 0;
    line.looks.fetch_add(1, std::memory_order_relaxed);
    const std::int64_t count = line.beats.load(std::memory_order_relaxed), time_ns = now_ns();
    if (count != seen) {
      seen = count;
      seen_ns = time_ns;
    } else if (time_ns - seen_ns >= duty.limit_ns) {
      say(device_fd, duty.word);
    }
  }
}

}  // namespace underact::guard
