#pragma once
#include <optional>
#include <vector>

#include "core/lab/stopwatch.h"
#include "core/sim/hand_script.h"
#include "core/tick/program.h"
#include "core/tradeoff/settings.h"

namespace underact::tradeoff {

/// A scene and the hand that moves in it.
struct Bench {
  scene::Description scene;  // with its meshes loaded
  sim::HandScript hand;
  double seconds = 4.0;
};

/// The bench with a hand that is made for the scene's arm: a built-in one is where that arm rests.
Bench benchOf(const scene::Description& scene, const sim::HandScript& hand, double seconds);

/// A run of the simulated arm under the servo, without a thread.
struct Run {
  int rate_hz = 1000;
  std::vector<Vec3> p_WT;   // the true position of the tip, tick by tick
  std::vector<Vec3> f_T_W;  // the force sent then
  lab::Cost tick, arm;      // of the servo's tick, and of the simulated arm, a period each
  bool faulted = false;     // it ended early
};

/// Runs the bench with the settings. exact: exact angles instead of encoder steps. Problems: those of the scene with
/// these settings (a closed form that does not exist, say).
Result<Run> run(const Bench& bench, const Settings& settings, bool exact = false);

/// The samples of the arm along a hand's path.
using JointPath = std::vector<arm::Sample>;

/// The samples along the hand's own path, as far as the arm reaches. at_s: times of the ticks, rising; encoders: with
/// encoder steps.
JointPath jointPathOf(const Bench& bench, const std::vector<double>& at_s, bool encoders);

/// The results of ticks along the hand's own path instead of the simulated arm's: the same positions for all settings.
struct Walk {
  // Constraint by constraint, tick by tick:
  std::vector<std::vector<Vec3>> p_WP;  // the tip where it is not unique
  std::vector<std::vector<Vec3>> e_W;   // the error, m
  std::vector<std::vector<double>> distance_m;
  std::vector<std::vector<Vec3>> rate_W;  // of the error, m/s; empty where no law damps
  std::vector<std::vector<bool>> acts;    // a target is there, and was a tick before
  lab::Cost tick;                         // of those in which a target acts
};

/// Runs the ticks along the path. Problems: those of the scene with these settings.
Result<Walk> walk(const Bench& bench, const Settings& settings, const JointPath& path);

/// The times from 0 to the bench's seconds, evenly spaced.
std::vector<double> timesOf(const Bench& bench, int rate_hz);

/// The distance of two runs at the times of the slower one. Where `fine` has no tick at such a time it is interpolated
/// linearly: at 16 kHz and 30 m/s^2, the most that the hands do, that is off by 1.5e-5 mm.
struct RunDifference {
  double rms_m = 0.0, max_m = 0.0;  // of the tips, root of the mean square and largest
  double rms_N = 0.0;               // of the forces
};
/// Of runs of the same bench, fine at no lower a rate than coarse. One of them without ticks: all 0.
RunDifference differenceOf(const Run& coarse, const Run& fine);

}  // namespace underact::tradeoff
