#include "core/servo/guard.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/translate.h"
#include "core/servo/guard_process.h"
#include "core/system/channel.h"
#include "core/system/resource_paths.h"
#include "core/system/thread.h"
#include "core/system/thread_priority.h"

namespace underact::servo {

Sentence guardPhrase(const Guard* guard, const Sentence& why_none) {
  const Sentence gap = guard == nullptr ? why_none : guard->gap();
  if (guard == nullptr || !gap.empty()) return phrase(TRANSLATE_NOOP("problem", "no guard: %1"), {gap});
  if (guard->replaced() == 0) return phrase(TRANSLATE_NOOP("problem", "guarded by a separate process"));
  return phrase(TRANSLATE_NOOP("problem", "guarded by a separate process (replaced so far: %1)"),
                {std::to_string(guard->replaced())});
}

Sentence noGuardText(const Sentence& gap) {
  return phrase(
      TRANSLATE_NOOP("problem",
                     "Nothing guards the arm: %1. If this program crashed now, the arm could hold its last force. "
                     "Until the guard is back, keep a hand on the arm's plug or switch, or switch the force off."),
      {gap});
}

namespace {

constexpr int kLookAfterGuard_ms = 250;
// A busy machine may delay a guard for a while; another one would be delayed, too.
constexpr std::int64_t kGuardStands_ns = 2'000'000'000;
constexpr int kLimitsInPatience = 10;  // in each of which it checks five times

}  // namespace

std::unique_ptr<Guard> Guard::start(const ZeroForceMessage& word, std::int64_t limit_ns, const std::string& program,
                                    Sentence& why) {
  if (word.fd < 0) {
    why = phrase(TRANSLATE_NOOP("problem", "this arm cannot be reached from outside the program"));
    return nullptr;
  }
  const Result<std::string> path = program.empty() ? system::findProgram("underact-guard") : program;
  if (!path) {
    why = path.problems().front().sentence;
    return nullptr;
  }
  auto process = std::make_unique<GuardProcess>(word, limit_ns, path.value());
  system::Doorbell wake;
  if (process->line() == nullptr || wake.descriptor() < 0 || !process->start()) {
    why = std::strerror(process->failure() != 0 ? process->failure() : errno);
    return nullptr;
  }
  return std::unique_ptr<Guard>(new Guard(std::move(process), limit_ns, std::move(wake)));
}

Guard::Guard(std::unique_ptr<GuardProcess> process, std::int64_t limit_ns, system::Doorbell wake)
    : process_(std::move(process)),
      patience_ns_(std::max(kGuardStands_ns, kLimitsInPatience * limit_ns)),
      wake_(std::move(wake)),
      thread_(&Guard::watch, this) {}

Guard::~Guard() {
  wake_.ring();
  thread_.join();
}

std::atomic<std::int64_t>& Guard::beats() {
  return process_->line()->beats;
}

Sentence Guard::gap() const {
  const std::scoped_lock lock(gap_mutex_);
  return gap_;
}

void Guard::setGap(Sentence gap) {
  const std::scoped_lock lock(gap_mutex_);
  gap_ = std::move(gap);
}

void Guard::watch() {
  system::nameThread("underact-warden");
  system::setOwnPriority({});  // the creating thread may be real-time
  while (waitUntilItEnds()) {
    setGap(phrase(TRANSLATE_NOOP("problem", "the guard has ended and is being restarted")));
    if (!startAnother()) return;
    replaced_.fetch_add(1, std::memory_order_relaxed);
    setGap({});
  }
}

/// true: the guard has ended; false: the watching is to end. A guard that hangs is killed.
bool Guard::waitUntilItEnds() {
  const std::atomic<std::int64_t>& looks = process_->line()->looks;
  std::int64_t seen = looks.load(std::memory_order_relaxed), seen_ns = system::monotonicNow_ns();
  for (;;) {
    const std::array ends{wake_.descriptor(), process_->endFd()};
    if (system::waitForAny(ends, kLookAfterGuard_ms) == 0) return false;
    if (process_->hasEnded()) return true;
    const std::int64_t count = looks.load(std::memory_order_relaxed), now_ns = system::monotonicNow_ns();
    if (std::exchange(seen, count) != count) seen_ns = now_ns;
    if (now_ns - seen_ns > patience_ns_) process_->kill();
  }
}

/// Starts another guard as soon as the pace allows; false: the watching is to end.
bool Guard::startAnother() {
  for (;;) {
    if (isStopRequested(pace_.next_ns(system::monotonicNow_ns()))) return false;
    if (process_->start()) return true;
    setGap(phrase(TRANSLATE_NOOP("problem", "the guard has ended and does not restart (%1)"),
                  {std::string(std::strerror(process_->failure()))}));
  }
}

/// Waits until then; true: it is told to end.
bool Guard::isStopRequested(std::int64_t until_ns) const {
  for (std::int64_t left_ns = 0; (left_ns = until_ns - system::monotonicNow_ns()) > 0;) {
    if (system::waitToRead(wake_.descriptor(), static_cast<int>(left_ns / 1'000'000 + 1))) return true;
  }
  return false;
}

}  // namespace underact::servo
