#include "device/openhaptics/exchange.h"

#include <algorithm>

namespace underact::device::openhaptics {

bool Exchange::read(arm::Sample& sample) noexcept {
  const arm::Sample& newest = samples_.latest();
  if (newest.time_ns <= given_ns_ || newest.time_ns == 0) return false;
  sample = newest;
  sample.buttons |= pressed_.exchange(0, std::memory_order_relaxed);
  given_ns_ = newest.time_ns;
  given_epoch_ = newest.epoch;
  return true;
}

void Exchange::write(const Vec3& f_T_W) noexcept {
  forces_.back() = {f_T_W, given_epoch_};
  forces_.publish();
  is_cut_.store(false, std::memory_order_relaxed);
  writes_.fetch_add(1, std::memory_order_release);
}

void Exchange::cut() noexcept {
  is_cut_.store(true, std::memory_order_relaxed);
}

void Exchange::offer(const arm::Sample& sample, std::uint32_t pressed) noexcept {
  if (pressed != 0) pressed_.fetch_or(pressed, std::memory_order_relaxed);
  samples_.back() = sample;
  samples_.publish();
}

Vec3 Exchange::wanted(std::uint32_t epoch) noexcept {
  const std::int64_t writes = writes_.load(std::memory_order_acquire);
  stale_ = writes == seen_writes_ ? std::min(stale_ + 1, kStalePeriods + 1) : 0;
  seen_writes_ = writes;
  if (stale_ > kStalePeriods || is_cut_.load(std::memory_order_relaxed)) return Vec3::Zero();
  const Force& newest = forces_.latest();
  return newest.epoch == epoch ? newest.f_T_W : Vec3::Zero();
}

}  // namespace underact::device::openhaptics
