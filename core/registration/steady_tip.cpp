#include "core/registration/steady_tip.h"

#include <algorithm>
#include <cmath>

namespace underact::registration {
namespace {

constexpr double kSpread_m = 1e-3, kDrift_m = 1e-3;  // a tip at rest on its point stays within a tenth of this
constexpr double kGap_s = 0.1;                       // after such a gap the tip may have moved
constexpr double kNanosecond_s = 1e-9;

}  // namespace

std::optional<HeldTip> SteadyTip::add(std::int64_t time_ns, const Vec3& p_WT) {
  if (!running_ || !p_WT.allFinite()) return {};
  const double since_s = kNanosecond_s * static_cast<double>(time_ns - last_ns_);
  if (!has_one_ || since_s < 0.0 || since_s > kGap_s) {
    begin();
    has_one_ = true;
    began_ns_ = time_ns;
    p_WOrigin_ = p_WT;
  } else if (since_s == 0.0) {
    return {};  // the same sample again
  }
  last_ns_ = time_ns;
  Sums& half = share() < 0.5 ? first_ : second_;
  const Vec3 away = p_WT - p_WOrigin_;
  half.p += away;
  half.squares += away.squaredNorm();
  ++half.count;
  if (share() < 1.0) return {};
  running_ = false;
  return result();
}

double SteadyTip::share() const {
  return std::min(1.0, kNanosecond_s * static_cast<double>(last_ns_ - began_ns_) / kHeld_s);
}

HeldTip SteadyTip::result() const {
  HeldTip held;
  held.samples = first_.count + second_.count;
  const double count = held.samples;
  const Vec3 mean = (first_.p + second_.p) / count;
  held.p_WT = p_WOrigin_ + mean;
  held.spread_m = std::sqrt(std::max(0.0, (first_.squares + second_.squares) / count - mean.squaredNorm()));
  held.drift_m = (second_.p / std::max(1, second_.count) - first_.p / std::max(1, first_.count)).norm();
  held.moved = held.spread_m > kSpread_m || held.drift_m > kDrift_m;
  return held;
}

}  // namespace underact::registration
