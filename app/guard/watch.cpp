#include "app/guard/watch.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <string_view>
#include <thread>

#include "core/servo/guard_line.h"
#include "core/system/channel.h"
#include "core/system/clock.h"
#include "core/system/shared_memory.h"

namespace underact::guard {
namespace {

constexpr int kLooksInLimit = 5;
// The last report is sent more than once: a report can be lost, and a tick in progress when the program died may still
// come after the first.
constexpr int kTimes = 5;
constexpr std::chrono::milliseconds kBetween{2};

void say(int device_fd, const std::string& word) {
  system::writeSome(device_fd, word);
}

/// The program has ended.
int sayLast(int device_fd, const std::string& word) {
  for (int time = 0; time < kTimes; ++time) {
    say(device_fd, word);
    std::this_thread::sleep_for(kBetween);
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
  const system::SharedMemory memory =
      system::SharedMemory::of(system::Descriptor(servo::kGuardLineFd), sizeof(servo::GuardLine));
  if (memory.begin() == nullptr) return 2;
  return watch(duty, *static_cast<servo::GuardLine*>(memory.begin()), servo::kGuardLifeFd, servo::kGuardDeviceFd);
}

int watch(const Duty& duty, servo::GuardLine& line, int life_fd, int device_fd) {
  const int look_ms = static_cast<int>(std::clamp<std::int64_t>(duty.limit_ns / kLooksInLimit / 1'000'000, 1, 1000));
  std::int64_t seen = line.beats.load(std::memory_order_relaxed), seen_ns = system::monotonicNow_ns();
  for (;;) {
    if (system::waitToRead(life_fd, look_ms)) return line.farewell == 0 ? sayLast(device_fd, duty.word) : 0;
    line.looks.fetch_add(1, std::memory_order_relaxed);
    const std::int64_t count = line.beats.load(std::memory_order_relaxed), time_ns = system::monotonicNow_ns();
    if (count != seen) {
      seen = count;
      seen_ns = time_ns;
    } else if (time_ns - seen_ns >= duty.limit_ns) {
      say(device_fd, duty.word);
    }
  }
}

}  // namespace underact::guard
