#pragma once
#include <array>

#include "core/base/fault.h"
#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/safety/limits.h"

namespace underact::safety {

/// The heat of the driven joints' motors: 0 cold, 1 at their continuous torque.
using Heat = PerDriven;

/// All memory of the gate.
struct GateState {
  double level = 0.0;         // share of the force that passes, 0 to 1
  int missed = 0;             // ticks in a row without a new sample
  int late = 0;               // ticks in a row that came late while the servo pushed
  double still_s = 0.0;       // how long the sample has been the same to the bit
  Vec3 v_WT = Vec3::Zero();   // the tip's velocity, filtered
  Vec3 f_T_W = Vec3::Zero();  // sent last
  Vec3 m_T_W = Vec3::Zero();  // the moment sent last
  Heat heat{};
  Fault letting_go = {};  // why the force is being ramped to zero; becomes the fault at zero
  Fault fault = {};       // what stopped the servo; stays until it is started again
};

/// For bytes from a file: whether the gate's state is finite, shares are within 0 to 1, and faults exist.
bool isValid(const GateState& state) noexcept;

/// A joint whose motor the gate watches.
struct DrivenJoint {
  Vec3 J_v, J_w;                          // the tip's motion for its rate: m/rad and rad/rad, or 1 and 0
  double room_below_rad, room_above_rad;  // to its stops; of a slide as far as it counts
};

/// Configuration and motion of the arm in this tick.
struct Motion {
  Motion() noexcept UNDERACT_REAL_TIME {}      // what is not read is not written, either: a tick has no time for it
  Vec3 v_WT = Vec3::Zero();                    // of the tip since the last sample, m/s
  bool moved = true;                           // some joint angle has changed, by at least a bit
  std::size_t count = 0;                       // of driven joints; 0: no limits of heat and edge
  std::array<DrivenJoint, kMaxDriven> joints;  // those beyond count are not read
  // What the motors render of a force, arm::renderable(), and of force and moment, arm::renderableWrench().
  bool renders_all = true;  // of a force: `renders` is not read
  bool turns = false;       // they render a moment: renders_wrench is read in place of `renders`
  Mat3 renders;
  Mat6 renders_wrench;
};

/// The input of the gate in this tick.
struct GateInput {
  Vec3 f_T_W = Vec3::Zero();
  bool engage = false;   // the servo is to push; false: it lets go
  bool restart = false;  // Start was pressed: forget the last fault
  Fault fault = {};      // what is wrong with this tick's sample
  bool late = false;     // this tick started a whole period late
  Motion motion = {};
  double waited_s = 0.0;      // beside dt_s: deadlines that passed without a tick, >= 0
  Vec3 m_T_W = Vec3::Zero();  // a moment about the tip, N m; without effect on an arm that renders none
};

struct Gated;

/// A force that has passed the gate; the only kind a device takes. Only gate() makes one that is not zero.
class GatedForce {
 public:
  GatedForce() = default;  // zero is always safe
  const Vec3& f_T_W() const noexcept UNDERACT_REAL_TIME { return f_T_W_; }
  /// Beside it a moment about the tip, N m; zero but of an arm whose motors render one.
  const Vec3& m_T_W() const noexcept UNDERACT_REAL_TIME { return m_T_W_; }

 private:
  friend Gated gate(const Limits& limits, const GateState& state, const GateInput& asked,
                    double dt_s) noexcept UNDERACT_REAL_TIME;
  GatedForce(const Vec3& f_T_W, const Vec3& m_T_W) noexcept UNDERACT_REAL_TIME : f_T_W_(f_T_W), m_T_W_(m_T_W) {}
  Vec3 f_T_W_ = Vec3::Zero();
  Vec3 m_T_W_ = Vec3::Zero();
};

/// The result of gate().
struct Gated {
  GatedForce force;
  GateState next;
  Cuts cuts;         // which limits act, and how much each took off
  Fault fault = {};  // why the force is zero, if a fault is why
};

/// Checks for finite numbers, then applies the limits in the order of Cuts, with soft start and release between heat
/// and slew. A missing or old sample gives zero force and, more than max_missed times in a row, a lasting fault; a
/// force or sample that is not finite, or a jump, gives such a fault at once; too many late ticks in a row first ramp
/// the force to zero. dt_s: a period of the servo, >= 0. What protects by slowness (soft start, slew) advances by dt_s
/// alone, however late the tick; what protects by elapsed time (release, heat, frozen time) also counts waited_s. Gives
/// |force| <= max_force_N (1 + 4 ulp) and |moment| <= max_moment_N_m (1 + 4 ulp), finite for any input. A moment is
/// clamped, slowed (by kMomentArm_m) and ramped as the force is, and every limit of a joint scales both. Cost:
/// constant.
Gated gate(const Limits& limits, const GateState& state, const GateInput& asked,
           double dt_s) noexcept UNDERACT_REAL_TIME;

/// The time of the tip's motion since the last sample, s, for the limits on its speed: by the arm's clock, which is the
/// most accurate, but at most four times what the servo counted, which is the greatest error of a read that waits two
/// periods, twice in a row: so a jump of the arm's clock cannot make a jump of the tip look slow.
double travelTime_s(double by_arm_s, double by_servo_s) noexcept UNDERACT_REAL_TIME;

/// f_T_W limited to max_force_N in its direction, each coordinate within 4 ulp of the length; zero where it is not
/// finite. No overflow up to 1e308. Source: Beckman 2007, code 3.4; erratum (test for a number first: NaN passes |F| >
/// clamp).
Vec3 clampForce(const Vec3& f_T_W, double max_force_N) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::safety
