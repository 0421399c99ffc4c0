#include "core/servo/arm_clock_watch.h"

#include <algorithm>

#include "core/base/units.h"

namespace underact::servo {
namespace {

// Jumps are limited to this, so that the sums cannot overflow.
constexpr std::int64_t kFar_ns = 1'000'000'000'000'000'000;  // 32 years

/// The difference, which wraps instead of overflowing; a wrapped one is found by its size, or is not newer.
std::int64_t stepOf(std::int64_t from_ns, std::int64_t to_ns) noexcept UNDERACT_REAL_TIME {
  const auto step_ns =
      static_cast<std::int64_t>(static_cast<std::uint64_t>(to_ns) - static_cast<std::uint64_t>(from_ns));
  return std::min(step_ns, kFar_ns);
}

}  // namespace

void ArmClockWatch::begin(std::int64_t sample_ns, std::int64_t earliest_ns, std::int64_t latest_ns) noexcept {
  has_begun_ = true;
  last_ns_ = sample_ns;
  begin_earliest_ns_ = earliest_ns;
  begin_latest_ns_ = latest_ns;
  advanced_ns_ = counted_ns_ = 0;
}

Fault ArmClockWatch::check(std::int64_t sample_ns, std::int64_t earliest_ns, std::int64_t latest_ns,
                           std::int64_t period_ns) noexcept {
  if (!has_begun_) {
    begin(sample_ns, earliest_ns, latest_ns);
    return {};
  }
  const std::int64_t step_ns = stepOf(last_ns_, sample_ns);
  if (step_ns <= 0) return {};
  last_ns_ = sample_ns;
  advanced_ns_ += step_ns;
  counted_ns_ += period_ns;
  const std::int64_t max_ns = std::max(latest_ns - begin_earliest_ns_, counted_ns_);
  const std::int64_t min_ns = std::min(earliest_ns - begin_latest_ns_, counted_ns_);
  const bool is_ahead = advanced_ns_ > max_ns + kSlack_ns, is_behind = advanced_ns_ < min_ns - kSlack_ns;
  if (is_ahead || is_behind) {
    has_begun_ = false;
    return {FaultKind::OddClock, kSecondPerNanosecond * static_cast<double>(advanced_ns_),
            kSecondPerNanosecond * static_cast<double>(is_ahead ? max_ns : min_ns)};
  }
  if (earliest_ns - begin_latest_ns_ >= kWindow_ns) begin(sample_ns, earliest_ns, latest_ns);
  return {};
}

}  // namespace underact::servo
