#pragma once
#include <array>

#include "core/base/fault.h"
#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/safety/driven.h"
#include "core/safety/limits.h"

namespace underact::safety {

/// The memory of the gate, as sessions have it.
struct GateCore {
  double level = 0.0;         // share of the force that passes, 0 to 1
  int missed = 0;             // ticks in a row without a new sample
  int late = 0;               // ticks in a row that came late while the servo pushed
  double still_s = 0.0;       // how long the sample has been the same to the bit
  Vec3 v_WT = Vec3::Zero();   // the tip's velocity, filtered
  Vec3 f_T_W = Vec3::Zero();  // sent last
  Vec3 heat = Vec3::Zero();   // of motors 1 to 3: 0 cold, 1 at their continuous torque
  Fault letting_go = {};      // why the force is being ramped to zero; becomes the fault at zero
  Fault fault = {};           // what stopped the servo; stays until it is started again
};

/// All memory of the gate: with that of an arm that is not of the Omni's form.
struct GateState : GateCore {
  std::array<double, kMostDriven - 3> more_heat{};  // of its driven joints beyond the third
  Vec3 m_T_W = Vec3::Zero();                        // the moment sent last
};

/// For bytes from a file: whether the gate's state is finite, shares are within 0 to 1, and faults exist.
bool isValid(const GateState& state) noexcept;

/// Configuration and motion of the arm in this tick.
struct Motion {
  Vec3 v_WT = Vec3::Zero();  // of the tip since the last sample, m/s
  bool moved = true;         // some joint angle has changed, by at least a bit
  Mat3 J_p = Mat3::Zero();   // from the rates of joints 1 to 3 to v_WT; zero: no limits of heat and edge
  Vec3 room_below_rad = Vec3::Constant(kInfinity);  // of joints 1 to 3, to their stops
  Vec3 room_above_rad = Vec3::Constant(kInfinity);
  Mat3 renders = Mat3::Identity();  // what the motors render of a force: see Driven
  const Driven* driven = nullptr;   // of an arm that is not of the Omni's form, in place of joints 1 to 3
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
