#include "device/replayed_arm.h"

#include <algorithm>
#include <cmath>

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/servo/touch_pages.h"

namespace underact::device {
namespace {

constexpr std::size_t kPlaces = 4 * servo::kFastest_hz;  // 4 s at any rate

std::int64_t lastRow(const Recorded& recorded) noexcept UNDERACT_REAL_TIME {
  return static_cast<std::int64_t>(recorded.rows.size()) - 1;
}

/// A joint that rotates without end is the same a whole turn later: it takes the shorter way.
double between(double from_rad, double to_rad, double share, bool is_endless) noexcept UNDERACT_REAL_TIME {
  double travel_rad = to_rad - from_rad;
  if (is_endless && travel_rad > kPi) travel_rad -= 2.0 * kPi;
  if (is_endless && travel_rad < -kPi) travel_rad += 2.0 * kPi;
  return from_rad + share * travel_rad;
}

}  // namespace

ReplayedArm::ReplayedArm(std::unique_ptr<servo::DevicePort> inner, int rate_hz)
    : inner_(std::move(inner)), rate_hz_(std::max(rate_hz, 1)), period_ns_(1'000'000'000 / rate_hz_), places_(kPlaces) {
  servo::touchPages(places_);
}

servo::DeviceInfo ReplayedArm::info() const {
  const std::scoped_lock lock(title_mutex_);
  if (title_.empty()) return inner_->info();
  return {phrase(TRANSLATE_NOOP("problem", "Recorded arm: %1"), {title_}), true, false, 0.0};
}

Sentence ReplayedArm::fixedRateReason() const {
  if (isReplaying())
    return phrase(TRANSLATE_NOOP("problem", "A recording is being replayed. Close it, then change the rate."));
  return inner_->fixedRateReason();
}

Sentence ReplayedArm::rateRefusal(int rate_hz) const {
  return isReplaying() ? fixedRateReason() : inner_->rateRefusal(rate_hz);
}

void ReplayedArm::setRate(int rate_hz) {
  rate_hz_ = std::max(rate_hz, 1);
  period_ns_ = 1'000'000'000 / rate_hz_;
  inner_->setRate(rate_hz);
}

void ReplayedArm::send() {
  ++orders_.number;
  slot_.back() = orders_;
  slot_.publish();
  const std::uint64_t taken = taken_.load(std::memory_order_acquire);
  kept_.erase(
      std::remove_if(kept_.begin(), kept_.end(), [&](const auto& one) { return one.first != 0 && one.first <= taken; }),
      kept_.end());
}

void ReplayedArm::replay(std::shared_ptr<const Recorded> recorded) {
  if (recorded != nullptr && recorded->rows.empty()) recorded.reset();
  {
    const std::scoped_lock lock(title_mutex_);
    title_ = recorded != nullptr ? recorded->name : std::string();
  }
  for (auto& [let_go, one] : kept_) let_go = let_go == 0 ? orders_.number + 1 : let_go;
  orders_.recorded = recorded.get();
  ++orders_.opened;
  orders_.plays = false;
  orders_.row = 0;
  orders_.loop_from = 0;
  orders_.loop_to = -1;
  moved_number_ = sought_number_ = orders_.number + 1;
  if (recorded != nullptr) kept_.emplace_back(0, std::move(recorded));
  send();
}

void ReplayedArm::play() {
  orders_.plays = true;
  ++orders_.moved;
  moved_number_ = orders_.number + 1;
  send();
}

void ReplayedArm::pause() {
  orders_.plays = false;
  ++orders_.moved;
  moved_number_ = orders_.number + 1;
  send();
}

void ReplayedArm::seek(std::int64_t row) {
  if (orders_.recorded == nullptr) return;
  orders_.row = std::clamp<std::int64_t>(row, 0, lastRow(*orders_.recorded));
  orders_.plays = isPlaying();  // it may have ended by itself
  ++orders_.sought;
  sought_number_ = orders_.number + 1;
  ++orders_.moved;
  moved_number_ = orders_.number + 1;
  send();
}

void ReplayedArm::setSpeed(double speed) {
  if (!std::isfinite(speed)) return;
  orders_.speed = std::clamp(speed, kSlowest, kFastest);
  send();
}

void ReplayedArm::setLoop(const std::optional<std::pair<std::int64_t, std::int64_t>>& rows) {
  if (orders_.recorded == nullptr) return;
  const std::int64_t last = lastRow(*orders_.recorded);
  orders_.loop_from = rows ? std::clamp<std::int64_t>(rows->first, 0, last) : 0;
  orders_.loop_to = rows ? std::clamp<std::int64_t>(rows->second, 0, last) : -1;
  send();
}

void ReplayedArm::tell(std::int64_t time_ns, bool moves) noexcept {
  row_.store(at_, std::memory_order_relaxed);
  playing_.store(plays_, std::memory_order_relaxed);
  places_.push({time_ns, at_, moves});
}

void ReplayedArm::jumpTo(std::int64_t row) noexcept {
  at_ = static_cast<double>(row);
  ++epoch_;
}

void ReplayedArm::seekTo(std::int64_t row) noexcept {
  const bool is_next = static_cast<double>(row) == std::floor(at_) + 1.0 &&
                       !now_.recorded->rows[static_cast<std::size_t>(row)].begins_anew;
  if (!is_next) return jumpTo(row);
  at_ = static_cast<double>(row);
}

/// True: the position to be at now.
bool ReplayedArm::takeUp(const Orders& orders) noexcept {
  const bool is_another = orders.opened != now_.opened;
  const bool is_sought = orders.sought != now_.sought;
  const bool is_moved = orders.moved != now_.moved;
  now_ = orders;
  if (is_another) {
    plays_ = false;
    jumpTo(0);
  }
  if (now_.recorded == nullptr) return true;
  const bool begins_again =
      is_moved && now_.plays && !plays_ && at_ >= static_cast<double>(lastRow(*now_.recorded)) && !is_another;
  if (is_sought) {
    seekTo(now_.row);
  } else if (begins_again) {
    jumpTo(now_.loop_to > now_.loop_from ? now_.loop_from : 0);
  }
  if (is_moved) plays_ = now_.plays;
  return is_another || is_sought || begins_again;
}

/// The joints at at_.
arm::JointAngles ReplayedArm::joints() const noexcept {
  const auto row = static_cast<std::size_t>(at_);
  const double share = at_ - static_cast<double>(row);
  const std::vector<RecordedRow>& rows = now_.recorded->rows;
  if (share == 0.0 || row + 1 >= rows.size() || rows[row + 1].begins_anew) return rows[row].q_rad;
  arm::JointAngles q_rad{};
  for (std::size_t joint = 0; joint < q_rad.size(); ++joint) {
    q_rad[joint] = between(rows[row].q_rad[joint], rows[row + 1].q_rad[joint], share, joint == 3 || joint == 5);
  }
  return q_rad;
}

/// One step further within the recording, across rows that are not continuous.
void ReplayedArm::goOn(double step) noexcept {
  const Recorded& recorded = *now_.recorded;
  const double next = step == 1.0 ? std::floor(at_) + 1.0 : at_ + step;
  const auto from = static_cast<std::int64_t>(at_), to = static_cast<std::int64_t>(next);
  at_ = next;
  for (std::int64_t row = from + 1; row <= to; ++row) {  // 40 at most: 10 kHz on 1 kHz at four times the speed
    if (recorded.rows[static_cast<std::size_t>(row)].begins_anew) {
      ++epoch_;
      return;
    }
  }
}

void ReplayedArm::advance() noexcept {
  const Recorded& recorded = *now_.recorded;
  const double step = now_.speed * static_cast<double>(recorded.rate_hz) / static_cast<double>(rate_hz_);
  const bool loops = now_.loop_to > now_.loop_from;
  const std::int64_t end = loops ? now_.loop_to : lastRow(recorded);
  const bool is_outside = loops && at_ < static_cast<double>(now_.loop_from);
  if (!is_outside && at_ + step <= static_cast<double>(end)) return goOn(step);
  if (loops) return jumpTo(now_.loop_from);
  const bool has_more = at_ < static_cast<double>(end);
  if (has_more) goOn(static_cast<double>(end) - at_);
  plays_ = false;
}

/// The other arm's own sample, on a clock that does not run back because of a replay.
void ReplayedArm::handThrough(bool has_sample, const arm::Sample& own, arm::Sample& sample) noexcept {
  sample = own;
  if (!has_sample) return;
  if (is_back_) ahead_ns_ = time_ns_ + period_ns_ - own.time_ns;
  is_back_ = false;
  if (own.epoch != inner_epoch_) ++epoch_;
  inner_epoch_ = own.epoch;
  sample.time_ns += ahead_ns_;
  sample.epoch = epoch_;
  time_ns_ = sample.time_ns;
}

bool ReplayedArm::read(arm::Sample& sample) noexcept {
  const Orders& orders = slot_.latest();
  const bool was_replaying = now_.recorded != nullptr;
  const double before = at_;
  const bool is_placed = orders.number != now_.number && takeUp(orders);
  arm::Sample own;
  const bool has_sample = inner_->read(own);
  if (now_.recorded == nullptr) {
    is_back_ |= was_replaying;
    handThrough(has_sample, own, sample);
    playing_.store(false, std::memory_order_relaxed);
    taken_.store(now_.number, std::memory_order_release);
    return has_sample;
  }
  if (plays_ && !is_placed) advance();
  time_ns_ += period_ns_;
  sample.time_ns = time_ns_;
  sample.q_rad = joints();
  sample.buttons = now_.recorded->rows[static_cast<std::size_t>(at_)].buttons;
  sample.epoch = epoch_;
  tell(time_ns_, at_ != before || is_placed);
  taken_.store(now_.number, std::memory_order_release);
  return true;
}

void ReplayedArm::write(const safety::GatedForce& force) noexcept {
  inner_->write(now_.recorded != nullptr ? safety::GatedForce{} : force);
}

}  // namespace underact::device
