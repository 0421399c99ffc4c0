#pragma once
#include <array>

#include "core/base/fault.h"
#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/safety/limits.h"

namespace underact::safety {

/// All memory of the gate.
struct GateState {
  double level = 0.0;         // share of the force that passes, 0 to 1
  int missed = 0;             // ticks in a row without a new sample
  int late = 0;               // ticks in a row that came late while the servo pushed
  double still_s = 0.0;       // how long the sample has been the same to the bit
  Vec3 v_WT = Vec3::Zero();   // the tip's velocity, filtered
  Vec3 f_T_W = Vec3::Zero();  // sent last
  Vec3 heat = Vec3::Zero();   // of motors 1 to 3: 0 cold, 1 at their continuous torque
  Fault letting_go = {};      // why the force is on its way to zero; becomes the fault when it is there
  Fault fault = {};           // what stopped the servo; stays until it is started again
};

/// Of bytes from a file: what the gate keeps is finite, a share is one, a fault one that there is.
bool isSound(const GateState& state) noexcept;

/// How the arm stands and moves in this tick.
struct Motion {
  Vec3 v_WT = Vec3::Zero();  // of the tip since the last sample, m/s
  bool moved = true;         // some joint is not where it was to the bit
  Mat3 J_p = Mat3::Zero();   // v_WT of the rates of joints 1 to 3; zero: heat and edge are not looked at
  Vec3 room_below_rad = Vec3::Constant(kInfinity);  // of joints 1 to 3, to their stops
  Vec3 room_above_rad = Vec3::Constant(kInfinity);
};

/// What is asked of the gate this tick.
struct Asked {
  Vec3 f_T_W = Vec3::Zero();
  bool engage = false;   // the servo is to push; false: it lets go
  bool restart = false;  // Start was pressed: forget the last fault
  Fault fault = {};      // what is wrong with this tick's sample
  bool late = false;     // this tick started a whole period late
  Motion motion = {};
  double waited_s = 0.0;  // beside dt_s: deadlines that passed without a tick, >= 0
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

/// What gate() makes of what was asked.
struct Gated {
  GatedForce force;
  GateState next;
  Cuts cuts;         // which limits act, and how much each took off
  Fault fault = {};  // why the force is zero, if a fault is why
};

/// Finite check, then the limits in the order of Cuts, soft start and release between heat and slew. A sample that is
/// missing or old gives zero force and, more than max_missed times in a row, a fault that lasts; a force or sample that
/// is not a number, or a jump, gives such a fault at once; too many late ticks in a row let the force go first. dt_s:
/// a period of the servo, >= 0. What protects by being slow (soft start, slew) goes on by it alone, however late the
/// tick; what protects by going on (release, heat, frozen time) counts what was waited, too. Gives |force| <=
/// max_force_N (1 + 4 ulp), finite whatever comes in. Cost: constant.
Gated gate(const Limits& limits, const GateState& state, const Asked& asked, double dt_s) noexcept UNDERACT_REAL_TIME;

/// In what time the tip went its way since the last sample, s, for the limits on its speed. By the arm's clock, which
/// knows best when a sample was taken; but no more than four times what the servo counted, which is what a read that
/// waits two periods, twice over, may be off by: a clock that leaps ahead cannot make a leap of the tip look slow.
double wayTime_s(double by_arm_s, double by_servo_s) noexcept UNDERACT_REAL_TIME;

/// f_T_W cut to max_force_N with its direction kept, each coordinate within 4 ulp of the size; zero where it is not
/// finite. No overflow up to 1e308. Source: Beckman 2007, code 3.4; erratum (test for a number first: NaN passes |F| >
/// clamp).
Vec3 clampForce(const Vec3& f_T_W, double max_force_N) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::safety
