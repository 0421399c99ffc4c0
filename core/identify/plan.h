#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/scene/description.h"

namespace underact::identify {

/// What the hand does meanwhile.
enum class HandDoes : std::uint8_t { LetsGo, Presses, Turns };

/// What a stage is for. Settle: nothing is kept.
enum class StageKind : std::uint8_t { Settle, Swing, Rest, Press, Turn };

/// One scene, held for some time.
struct Stage {
  StageKind kind = StageKind::Settle;
  HandDoes hand = HandDoes::LetsGo;
  int axis = 0;           // x, y, z of a swing
  std::size_t place = 0;  // index into Plan::places_W
  double seconds = 0.0;
  scene::Description scene;
  bool is_beginning = false;  // where it is taken up again after it was stopped
};

/// What makePlan() is asked for.
struct Wanted {
  std::string arm = "omni-thesis";                  // a preset
  std::vector<Vec3> places_W = {{0.0, 0.0, 0.06}};  // 1 to 3, m
  int repeats = 2;                                  // of the swings along an axis
};

/// All that the arm is asked to do, one scene after the other: at each place swings along x, y and z, then a rest; at
/// the first one, last of all, a slow press and a turn of the wrist by the hand.
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

/// Problems: no such arm; a place that it does not reach with all swings about it.
Result<Plan> makePlan(const Wanted& wanted);

}  // namespace underact::identify
