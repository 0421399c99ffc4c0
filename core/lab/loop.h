#pragma once
#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/sim/plant.h"
#include "core/tick/step.h"

namespace underact::lab {

/// The simulated arm under the servo's own tick, without a thread: a tick is a period of the arm's clock, and the same
/// numbers every time.
class Loop {
 public:
  /// The tip rests at p_WT, and the hand wants it there. rate_hz: 1 to 1e6.
  Loop(const sim::Plant& plant, const Vec3& p_WT, int rate_hz);
  /// A period later, under the force of the last tick: the arm moves, and then the servo's tick.
  const tick::TickReport& tick(const tick::TickProgram& program, tick::TickState& state);
  // Its two halves, to be timed apart.
  void move();
  const tick::TickReport& think(const tick::TickProgram& program, tick::TickState& state);
  /// Where the hand wants the tip at the end of the next period.
  void wish(const sim::HandWish& wish) { wish_ = wish; }
  /// The tip is given this velocity.
  void nudge(const Vec3& v_WT) { arm_.v_WT = v_WT; }

  const sim::PlantState& arm() const { return arm_; }
  std::int64_t time_ns() const { return input_.sample.time_ns; }
  /// Of a tick.
  double period_s() const;

 private:
  sim::Plant plant_;
  sim::PlantState arm_;
  sim::HandWish wish_;
  std::int64_t period_ns_;
  tick::TickInput input_;
  tick::TickReport report_;
};

/// The gate that lets everything through: what a law does by itself.
safety::Limits withoutLimits(safety::Limits limits);

/// The first tick of a program with the tip in p_WT, by exact joints.
tick::TickReport firstTick(const tick::TickProgram& program, const sim::Plant& plant, const Vec3& p_WT);

/// Whether the arm comes to p_WT, to a micrometre.
bool isWithinReach(const sim::Plant& plant, const Vec3& p_WT);

/// Where the tip rests on its target: the target nearest to p_WT, and so on until it stays (a turned stylus moves it).
/// Problems: several targets or none; one that does not stay, or that the arm does not reach.
Result<Vec3> restingPlace(const tick::TickProgram& program, const sim::Plant& plant, Vec3 p_WT);

/// The scene with nothing but the constraint of that name (empty: the only one there is), its control its own.
/// Problems: no such name; several, and none named; a wall, which never pulls.
Result<scene::Description> onlyOne(scene::Description scene, const std::string& name);

}  // namespace underact::lab
