#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>

#include "core/base/translate.h"
#include "core/system/rtkit.h"

namespace underact::system {
namespace {

constexpr int kMaxByRtkit = 20;                 // rtkit's default maximum
constexpr std::uint64_t kLongest_us = 200'000;  // of uninterrupted computation, rtkit's default
constexpr std::uint64_t kPatience_us = 1000'000;

constexpr const char* kService = "org.freedesktop.RealtimeKit1";
constexpr const char* kObject = "/org/freedesktop/RealtimeKit1";

struct Release {
  void operator()(sd_bus* bus) const { sd_bus_flush_close_unref(bus); }
};

/// The error of a call, with the message of the refusing side.
class CallError {
 public:
  CallError() = default;
  ~CallError() { sd_bus_error_free(&error_); }
  CallError(const CallError&) = delete;
  CallError& operator=(const CallError&) = delete;
  sd_bus_error* get() { return &error_; }
  std::string words(int code) const { return error_.message != nullptr ? error_.message : std::strerror(-code); }

 private:
  sd_bus_error error_ = SD_BUS_ERROR_NULL;
};

/// Lowers the limit, never raises it: a stricter one stays.
bool limitTimeWithoutRest(std::uint64_t longest_us) {
  rlimit limit{};
  if (getrlimit(RLIMIT_RTTIME, &limit) != 0) return false;
  const rlim_t max_us = std::min<rlim_t>(longest_us, limit.rlim_max);
  limit = {std::min(limit.rlim_cur, max_us), max_us};
  return setrlimit(RLIMIT_RTTIME, &limit) == 0;
}

bool isRealTime() {
  const int policy = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
  return policy == SCHED_RR || policy == SCHED_FIFO;
}

}  // namespace

RtkitAnswer askRtkit() {
  sd_bus* opened = nullptr;
  if (const int code = sd_bus_open_system(&opened); code < 0)
    return {0, phrase(TRANSLATE_NOOP("problem", "no D-Bus: %1"), {std::strerror(-code)})};
  const std::unique_ptr<sd_bus, Release> bus(opened);
  sd_bus_set_method_call_timeout(bus.get(), kPatience_us);
  CallError absent;
  std::int32_t max_priority = 0;
  if (const int code = sd_bus_get_property_trivial(bus.get(), kService, kObject, kService, "MaxRealtimePriority",
                                                   absent.get(), 'i', &max_priority);
      code < 0) {
    return {0, phrase(TRANSLATE_NOOP("problem", "it does not answer: %1"), {absent.words(code)})};
  }
  std::int64_t longest_us = 0;  // older versions do not state it
  if (sd_bus_get_property_trivial(bus.get(), kService, kObject, kService, "RTTimeUSecMax", nullptr, 'x', &longest_us) <
          0 ||
      longest_us <= 0) {
    longest_us = static_cast<std::int64_t>(kLongest_us);
  }
  const int priority = std::min(kMaxByRtkit, static_cast<int>(max_priority));
  if (priority < 1) return {0, phrase(TRANSLATE_NOOP("problem", "it grants no priority"))};
  if (!limitTimeWithoutRest(std::min(kLongest_us, static_cast<std::uint64_t>(longest_us)))) {
    return {0, phrase(TRANSLATE_NOOP("problem", "RLIMIT_RTTIME cannot be set"))};
  }
  CallError refused;
  const auto thread = static_cast<std::uint64_t>(syscall(SYS_gettid));
  if (const int code = sd_bus_call_method(bus.get(), kService, kObject, kService, "MakeThreadRealtime", refused.get(),
                                          nullptr, "tu", thread, static_cast<std::uint32_t>(priority));
      code < 0) {
    return {0, refused.words(code)};
  }
  if (!isRealTime()) return {0, phrase(TRANSLATE_NOOP("problem", "it agreed, but nothing changed"))};
  return {priority, {}};
}

}  // namespace underact::system
#endif
