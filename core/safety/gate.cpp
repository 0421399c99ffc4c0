#include "core/safety/gate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/norms.h"

namespace underact::safety {
namespace {

bool isFinite(const Vec3& v) noexcept UNDERACT_REAL_TIME {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool isMissing(const Fault& fault) noexcept UNDERACT_REAL_TIME {
  return fault.kind == FaultKind::NoSample || fault.kind == FaultKind::StaleSample;
}

double sizeOf(const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME {
  const double largest = largestOf(f_T_W);
  if (!(largest > 0.0)) return 0.0;
  return std::min(largest * (f_T_W / largest).norm(), std::numeric_limits<double>::max());
}

/// Time that stands, goes back or is not a number moves nothing; a ramp of 0 s is a jump.
double moved(double level, bool up, double dt_s, double ramp_s) noexcept UNDERACT_REAL_TIME {
  if (!(dt_s > 0.0)) return level;
  if (!(ramp_s > 0.0)) return up ? 1.0 : 0.0;
  return up ? std::min(level + dt_s / ramp_s, 1.0) : std::max(level - dt_s / ramp_s, 0.0);
}

}  // namespace

Vec3 clampForce(const Vec3& f_T_W, double max_force_N) noexcept {
  if (!isFinite(f_T_W) || !(max_force_N > 0.0)) return Vec3::Zero();
  const double largest = largestOf(f_T_W);
  if (!(largest > 0.0)) return Vec3::Zero();
  const Vec3 shape = f_T_W / largest;  // so that no square overflows
  const double size = shape.norm();
  if (largest <= max_force_N / size) return f_T_W;
  return shape * (max_force_N / size);
}

Gated gate(const Limits& limits, const GateState& state, const Asked& asked, double dt_s) noexcept {
  GateState next = state;
  if (asked.restart) next = GateState{};
  Fault now = asked.fault;
  if (now.kind == FaultKind::None && !isFinite(asked.f_T_W)) now = {FaultKind::NotFinite, 0.0, 0.0};
  next.missed = isMissing(now) ? std::min(next.missed, limits.max_missed) + 1 : 0;
  if (now.kind == FaultKind::NoSample) {
    now.seen = next.missed;
    now.allowed = limits.max_missed;
  }
  const bool lasts = now.kind != FaultKind::None && (!isMissing(now) || next.missed > limits.max_missed);
  if (lasts && next.fault.kind == FaultKind::None) next.fault = now;
  if (now.kind != FaultKind::None || next.fault.kind != FaultKind::None) {
    next.level = 0.0;
    return {GatedForce{}, next, 0.0, next.fault.kind != FaultKind::None ? next.fault : now};
  }
  next.level = moved(next.level, asked.engage, dt_s, asked.engage ? limits.rise_s : limits.fall_s);
  const Vec3 clamped_T_W = clampForce(asked.f_T_W, limits.max_force_N);
  const double cut_N = std::max(0.0, sizeOf(asked.f_T_W) - sizeOf(clamped_T_W));
  return {GatedForce{next.level * clamped_T_W}, next, clamped_T_W == asked.f_T_W ? 0.0 : cut_N, Fault{}};
}

}  // namespace underact::safety
