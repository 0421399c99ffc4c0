#pragma once
#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/stability/trial.h"

namespace underact::stability {

/// A scene's constraint as a wall whose greatest stiffness is sought, where no formula exists: virtual robots, control
/// in joint space, meshes. The whole tick runs, without the gate's limits.
struct SceneWall {
  scene::Description scene;
  std::string constraint = {};  // by name; empty: the only one there is
  int rate_hz = 1000;
  double kd_N_s_per_m = 0.0;  // above 0: law PD with the scene's own filter; else P
  double mass_kg = 0.045;     // of arm and hand, whose tip is free otherwise
  double damping_N_s_per_m = 0.1;
  double friction_N = 0.0;
  bool encoders = false;
  Vec3 from_W = Vec3(0.021, 0.013, 0.055);  // the tip rests at first on the target nearest to here
};

/// How a trial of a scene ended.
struct SceneTrialResult {
  TrialResult trial;
  double min_energy_J = 0.0;  // the least energy of the constraint at any time: below 0 it was active
  bool is_passive = true;     // never active beyond the observer's rounding
  bool holds = true;          // false: the target follows the tip wherever it goes
};

/// Trials in the whole tick, of which the worst counts: the tip rests until the ramps are done, is given 5 mm/s in one
/// of three directions oblique to all axes, and its distance to the target is followed. Problems: those of the scene;
/// no such constraint, or several and none named; a wall, a target that is not unique or not within reach.
Result<SceneTrialResult> tryScene(const SceneWall& wall, double stiffness_N_per_m);

/// As simulatedLimit(): the greatest kp, N/m (in joint space as felt in the middle of the workspace), the same for x, y
/// and z, to `share` of itself. Rotational stiffness and joint springs stay. Problems: also where nothing holds the
/// tip, as within the reach of a robot of many joints.
Result<double> simulatedLimit(const SceneWall& wall, double share = 1e-2);

}  // namespace underact::stability
