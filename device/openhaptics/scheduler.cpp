#include "device/openhaptics/scheduler.h"

#include <algorithm>
#include <mutex>

#include "core/base/translate.h"
#include "device/openhaptics/errors.h"

namespace underact::device::openhaptics {
namespace {

std::mutex& mutex() {
  static std::mutex the_one;
  return the_one;
}

bool takes(const Calls& hd, int rate_hz) {
  (void)drain(hd);
  hd.hdSetSchedulerRate(static_cast<unsigned long>(rate_hz));
  return drain(hd).worst == Severity::None;
}

Sentence notTaken(int rate_hz) {
  return phrase(TRANSLATE_NOOP("problem", "The arm's driver did not accept the rate %1 Hz."),
                {std::to_string(rate_hz)});
}

Problems wentWrong(const Drained& drained) {
  return drained.worst == Severity::None ? Problems{} : Problems{{sentenceOf(drained.code), {}}};
}

Problems start(const Calls& hd) {
  (void)drain(hd);
  hd.hdStartScheduler();
  return wentWrong(drain(hd));
}

}  // namespace

Scheduler& Scheduler::theOne() {
  static Scheduler the_one;
  return the_one;
}

Result<Scheduled> Scheduler::join(const Calls& hd, int rate_hz, Callback callback, void* self) {
  const std::scoped_lock lock(mutex());
  if (users_ == 0) tryRates(hd);
  const Sentence refused = users_ > 0 ? refusesBeside(rate_hz) : refusesLocked(rate_hz);
  if (!refused.empty()) return Problems{{refused, {}}};
  if (users_ == 0 && !takes(hd, rate_hz)) return Problems{{notTaken(rate_hz), {}}};
  const Scheduled scheduled = hd.hdScheduleAsynchronous(callback, self, kMaxPriority);
  Problems problems = wentWrong(drain(hd));
  if (!problems.empty()) return problems;
  if (users_ == 0) problems = start(hd);
  if (!problems.empty()) {
    hd.hdStopScheduler();
    hd.hdUnschedule(scheduled);
    (void)drain(hd);
    return problems;
  }
  ++users_;
  rate_hz_ = rate_hz;
  return scheduled;
}

void Scheduler::leave(const Calls& hd, Scheduled scheduled) {
  const std::scoped_lock lock(mutex());
  if (users_ == 1) hd.hdStopScheduler();
  hd.hdUnschedule(scheduled);
  (void)drain(hd);
  users_ = std::max(users_ - 1, 0);
}

Problems Scheduler::setRate(const Calls& hd, int rate_hz) {
  const std::scoped_lock lock(mutex());
  if (rate_hz == rate_hz_) return {};
  const Sentence refused = refusesLocked(rate_hz);
  if (!refused.empty()) return {{refused, {}}};
  hd.hdStopScheduler();
  const bool taken = takes(hd, rate_hz);
  if (!taken) (void)takes(hd, rate_hz_);
  Problems problems = start(hd);
  if (taken) rate_hz_ = rate_hz;
  if (!taken) problems.push_back({notTaken(rate_hz), {}});
  return problems;
}

int Scheduler::users() const {
  const std::scoped_lock lock(mutex());
  return users_;
}

int Scheduler::rate_hz() const {
  const std::scoped_lock lock(mutex());
  return rate_hz_;
}

std::vector<int> Scheduler::rates() const {
  const std::scoped_lock lock(mutex());
  return rates_;
}

Sentence Scheduler::refuses(int rate_hz) const {
  const std::scoped_lock lock(mutex());
  return rate_hz == rate_hz_ && users_ > 0 ? Sentence() : refusesLocked(rate_hz);
}

Sentence Scheduler::refusesLocked(int rate_hz) const {
  if (users_ > 1) return refusesBeside(rate_hz);
  if (std::find(rates_.begin(), rates_.end(), rate_hz) != rates_.end()) return {};
  if (rates_.empty())
    return phrase(TRANSLATE_NOOP("problem", "The arm's driver accepts no rate at all. Restart the servo."));
  std::string list;
  for (const int rate : rates_) list += (list.empty() ? "" : ", ") + std::to_string(rate);
  return phrase(TRANSLATE_NOOP("problem", "The arm's driver supports %1 Hz, not %2. Choose one of these rates."),
                {list, std::to_string(rate_hz)});
}

Sentence Scheduler::refusesBeside(int rate_hz) const {
  if (rate_hz == rate_hz_) return {};
  return phrase(
      TRANSLATE_NOOP(
          "problem",
          "Another arm uses the same driver at %1 Hz, and both share one scheduler. Close one of them first."),
      {std::to_string(rate_hz_)});
}

void Scheduler::tryRates(const Calls& hd) {
  rates_.clear();
  for (const int rate_hz : kTriedRates_hz) {
    if (takes(hd, rate_hz)) rates_.push_back(rate_hz);
  }
}

}  // namespace underact::device::openhaptics
