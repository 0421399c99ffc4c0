#pragma once
#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/sim/plant.h"
#include "core/tick/step.h"

namespace underact::lab {

/// The simulated arm under the servo's own tick, without a thread: a tick is a period of the arm's clock, and the
/// results are the same every time.
class SimulatedLoop {
 public:
  /// The tip rests at p_WT, and the hand wants it there. rate_hz: 1 to 1e6.
  SimulatedLoop(const sim::Plant& plant, const Vec3& p_WT, int rate_hz);
  /// One period: the arm moves under the force of the last tick, then the servo ticks.
  const tick::TickReport& tick(const tick::TickProgram& program, tick::TickState& state);
  // Its two halves, to be timed apart.
  void move();
  const tick::TickReport& think(const tick::TickProgram& program, tick::TickState& state);
  /// Where the hand wants the tip at the end of the next period.
  void setSetpoint(const sim::HandSetpoint& setpoint) { setpoint_ = setpoint; }
  /// Sets the velocity of the tip.
  void nudge(const Vec3& v_WT) { arm_.v_WT = v_WT; }

  const sim::PlantState& arm() const { return arm_; }
  std::int64_t time_ns() const { return input_.sample.time_ns; }
  /// Of a tick.
  double period_s() const;

 private:
  sim::Plant plant_;
  sim::PlantState arm_;
  sim::HandSetpoint setpoint_;
  std::int64_t period_ns_;
  tick::TickInput input_;
  tick::TickReport report_;
};

/// The limits without clamp (1 MN), slew, speed, jump, edge and heat: the response of a law alone.
safety::Limits withoutLimits(safety::Limits limits);

/// The first tick of a program with the tip at p_WT, from exact joint angles.
tick::TickReport firstTick(const tick::TickProgram& program, const sim::Plant& plant, const Vec3& p_WT);

/// Whether the arm reaches p_WT, to a micrometre.
bool isWithinReach(const sim::Plant& plant, const Vec3& p_WT);

/// Where the tip rests on its target: the target nearest to p_WT, repeated until it stays (the stylus's orientation
/// changes it). Problems: several targets or none; one that does not stay, or that the arm does not reach.
Result<Vec3> restingPlace(const tick::TickProgram& program, const sim::Plant& plant, Vec3 p_WT);

/// The scene with nothing but the constraint of that name (empty: the only one there is), its control its own.
/// Problems: no such name; several, and none named; a wall, which never pulls.
Result<scene::Description> onlyOne(scene::Description scene, const std::string& name);

}  // namespace underact::lab
