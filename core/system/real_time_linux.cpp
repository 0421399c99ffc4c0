#ifdef __linux__
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>

#include "core/base/translate.h"
#include "core/system/cores.h"
#include "core/system/rtkit.h"
#include "core/system/thread.h"
#include "core/system/thread_priority.h"

namespace underact::system {
namespace {

constexpr int kPriority = 80;                    // above what a desktop runs, below the kernel's own threads (99)
constexpr std::size_t kStackBytes = 256 * 1024;  // several times the need of the deepest tick

/// Requests FIFO at kPriority, or as near to it as the limit of this login allows. 0: not granted.
int askForFifo() {
  rlimit limit{};
  getrlimit(RLIMIT_RTPRIO, &limit);
  const int allowed = static_cast<int>(std::min<rlim_t>(limit.rlim_cur, kPriority));
  for (const int priority : {kPriority, allowed}) {
    if (priority > 0 && setOwnPriority({SCHED_FIFO, priority})) return priority;
  }
  return 0;
}

/// Whether this process may lock more than its limit: unlimited, or privileged. Tried on inaccessible pages, which cost
/// nothing.
bool mayLockEverything() {
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) != 0) return false;
  if (limit.rlim_cur == RLIM_INFINITY) return true;
  const std::size_t beyond_bytes = static_cast<std::size_t>(limit.rlim_cur) + static_cast<std::size_t>(getpagesize());
  void* probe = mmap(nullptr, beyond_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_LOCKED, -1, 0);
  if (probe == MAP_FAILED) return false;
  munmap(probe, beyond_bytes);
  return true;
}

/// Locks the memory. With a limit, MCL_FUTURE would make allocations fail once it is reached, long after this call.
bool lockMemory() {
  return mayLockEverything() && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

[[gnu::noinline]] void touchStack() noexcept {
  std::array<volatile char, kStackBytes> stack;
  for (std::size_t at = 0; at < stack.size(); at += 1024) stack[at] = 0;
}

std::optional<int> isolatedCore() {
  std::ifstream file("/sys/devices/system/cpu/isolated");
  const std::string list{std::istreambuf_iterator<char>(file), {}};
  return firstCore(list);
}

enum class CoreChoice : std::uint8_t { AllCores, OneCore, IsolatedCore, Refused };

CoreChoice takeCore(int wanted, std::vector<Sentence>& also) {
  const std::optional<int> isolated = isolatedCore();
  const int core = wanted >= 0 ? wanted : isolated.value_or(-1);
  if (core < 0) {
    also.push_back(phrase(TRANSLATE_NOOP("problem", "all cores")));
    return CoreChoice::AllCores;
  }
  if (!runOnCore(core)) {
    also.push_back(phrase(TRANSLATE_NOOP("problem", "core %1 refused"), {std::to_string(core)}));
    return wanted >= 0 ? CoreChoice::Refused : CoreChoice::AllCores;  // an isolated core was not granted
  }
  if (wanted >= 0) {
    also.push_back(phrase(TRANSLATE_NOOP("problem", "core %1"), {std::to_string(core)}));
    return CoreChoice::OneCore;
  }
  also.push_back(phrase(TRANSLATE_NOOP("problem", "isolated core %1"), {std::to_string(core)}));
  return CoreChoice::IsolatedCore;
}

/// Requests the scheduling, and gives the name of what was granted. priority: that of FIFO, else 0.
Sentence takeMethod(SchedulingMethod method, std::vector<Sentence>& also, int& priority) {
  setOwnPriority({});  // a new thread inherits the scheduling of its creator
  priority = method == SchedulingMethod::Auto || method == SchedulingMethod::Fifo ? askForFifo() : 0;
  if (priority > 0) return "FIFO " + std::to_string(priority);
  if (method == SchedulingMethod::Auto || method == SchedulingMethod::Rtkit) {
    const RtkitAnswer answer = askRtkit();
    if (answer.priority > 0) return "rtkit " + std::to_string(answer.priority);
    also.push_back(phrase(TRANSLATE_NOOP("problem", "rtkit: %1"), {answer.refusal}));
  }
  return phrase(TRANSLATE_NOOP("problem", "normal"));
}

Sentence hintFor(const Scheduling& granted, const SchedulingRequest& wanted, int priority, bool locked,
                 CoreChoice place) {
  if (place == CoreChoice::Refused)
    return phrase(TRANSLATE_NOOP("problem", "The requested core does not exist, or is not available to this program."));
  if (granted.name == "normal" && wanted.method == SchedulingMethod::Normal)
    return phrase(
        TRANSLATE_NOOP("problem", "Real time was not requested, so ticks can be late when the computer is busy."));
  if (granted.name == "normal") {
    return phrase(TRANSLATE_NOOP(
        "problem",
        "The system did not grant real-time scheduling, so ticks can be late when the computer is busy. Put \"@users - "
        "rtprio 90\" and \"@users - memlock unlimited\" into a file in /etc/security/limits.d and log in again, or "
        "install rtkit; the guide's page real_time.md explains how."));
  }
  if (priority < kPriority) {
    return phrase(TRANSLATE_NOOP(
        "problem",
        "A higher priority would be better still. Put \"@users - rtprio 90\" and \"@users - memlock unlimited\" into a "
        "file in /etc/security/limits.d and log in again; the guide's page real_time.md explains how."));
  }
  if (wanted.lock_memory && !locked) {
    return phrase(TRANSLATE_NOOP(
        "problem",
        "Parts of the program may be swapped out, and a tick then waits for them. Put \"@users - memlock unlimited\" "
        "into a file in /etc/security/limits.d and log in again; the guide's page real_time.md explains how."));
  }
  if (place == CoreChoice::IsolatedCore) return {};
  return phrase(TRANSLATE_NOOP("problem",
                               "On a computer that is always busy, a core for the servo alone (isolcpus) is better "
                               "still; the guide's page real_time.md explains how."));
}

}  // namespace

Scheduling askForRealTime(const SchedulingRequest& wanted, int /*rate_hz*/) {
  Scheduling granted;
  int priority = 0;
  const CoreChoice place = takeCore(wanted.core, granted.also);
  const bool locked = wanted.lock_memory && lockMemory();
  granted.also.push_back(
      phrase(locked ? TRANSLATE_NOOP("problem", "memory locked") : TRANSLATE_NOOP("problem", "memory not locked")));
  // Without real-time scheduling the kernel delays every wait by 50 us, so as to wake less often.
  granted.also.push_back(phrase(prctl(PR_SET_TIMERSLACK, 1UL) == 0
                                    ? TRANSLATE_NOOP("problem", "timer slack 1 ns")
                                    : TRANSLATE_NOOP("problem", "timer slack unchanged")));
  touchStack();
  granted.also.push_back(phrase(TRANSLATE_NOOP("problem", "stack in memory")));
  granted.name = takeMethod(wanted.method, granted.also, priority);
  granted.hint = hintFor(granted, wanted, priority, locked, place);
  return granted;
}

}  // namespace underact::system
#endif
