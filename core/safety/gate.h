#pragma once
#include "core/base/fault.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::safety {

/// What the gate lets through.
struct Limits {
  double max_force_N = 0.0;  // the arm's continuous force
  double rise_s = 0.3;       // soft start: from nothing to the whole force
  double fall_s = 0.05;      // soft release
  int max_missed = 20;       // ticks in a row without a new sample, after which the servo stops for good
};

/// All memory of the gate.
struct GateState {
  double level = 0.0;  // share of the force that passes, 0 to 1
  int missed = 0;      // ticks in a row without a new sample
  Fault fault = {};    // what stopped the servo; stays until it is started again
};

/// What is asked of the gate this tick.
struct Asked {
  Vec3 f_T_W = Vec3::Zero();
  bool engage = false;   // the servo is to push; false: it lets go
  bool restart = false;  // Start was pressed: forget the last fault
  Fault fault = {};      // what is wrong with this tick's sample
};

struct Gated;

/// A force that has passed the gate; the only kind a device takes. Only gate() makes one that is not zero.
class GatedForce {
 public:
  GatedForce() = default;  // zero is always safe
  const Vec3& f_T_W() const noexcept UNDERACT_REAL_TIME { return f_T_W_; }

 private:
  friend Gated gate(const Limits& limits, const GateState& state, const Asked& asked,
                    double dt_s) noexcept UNDERACT_REAL_TIME;
  explicit GatedForce(const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME : f_T_W_(f_T_W) {}
  Vec3 f_T_W_ = Vec3::Zero();
};

struct Gated {
  GatedForce force;
  GateState next;
  double cut_N = 0.0;  // how much of the force's size the clamp took away
  Fault fault = {};    // why the force is zero, if a fault is why
};

/// Finite check, clamp that keeps the direction, soft start and release. A sample that is missing or old gives zero
/// force and, more than max_missed times in a row, a fault that lasts; a force or sample that is not a number gives
/// such a fault at once. dt_s: since the last tick, >= 0. Gives |force| <= max_force_N (1 + 4 ulp), finite whatever
/// comes in.
Gated gate(const Limits& limits, const GateState& state, const Asked& asked, double dt_s) noexcept UNDERACT_REAL_TIME;

/// f_T_W cut to max_force_N with its direction kept; zero where it is not finite. No overflow up to 1e308.
/// Source: Beckman 2007, code 3.4; erratum (test for a number first: NaN passes |F| > clamp).
Vec3 clampForce(const Vec3& f_T_W, double max_force_N) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::safety
