#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/scene/description.h"

namespace underact::identify {

/// What the hand does during a stage.
enum class HandTask : std::uint8_t { LetsGo, Presses, Turns };

/// What a stage measures. Settle: nothing is recorded.
enum class StageKind : std::uint8_t { Settle, Swing, Rest, Press, Turn };

/// One scene for some time.
struct Stage {
  StageKind kind = StageKind::Settle;
  HandTask hand = HandTask::LetsGo;
  int axis = 0;           // x, y, z of a swing
  std::size_t place = 0;  // index into Plan::places_W
  double seconds = 0.0;
  scene::Description scene;
  bool is_beginning = false;  // repeat() goes back to here
};

/// What makePlan() is asked for.
struct Wanted {
  scene::Description arm_of = {};                   // a scene with the arm
  std::vector<Vec3> places_W = {{0.0, 0.0, 0.06}};  // 1 to 3, m
};

/// The stages of a measurement: at each position swings along x, y and z, then a rest; finally, at the first position,
/// a slow press and a rotation of the wrist by the hand.
struct Plan {
  std::vector<Vec3> places_W;
  std::vector<Stage> stages;
  /// How long all stages take together.
  double seconds() const;
};

// Soft along the swing, so that the tip is free; stiff and damped across it. The press has the usual stiffness.
inline constexpr double kSwing_N_per_mm = 0.1, kPress_N_per_mm = 0.5;
inline const Vec3 kPressAlong_W = -Vec3::UnitY();  // down
inline constexpr double kPressWay_m = 3e-3;

/// Problems: no such arm; a position about which the arm cannot reach all swings.
Result<Plan> makePlan(const Wanted& wanted);

}  // namespace underact::identify
