#pragma once
#include <optional>
#include <vector>

#include "core/lab/stopwatch.h"
#include "core/sim/hand_script.h"
#include "core/tick/program.h"
#include "core/trade/settings.h"

namespace underact::trade {

/// A scene and the hand that moves in it.
struct Bench {
  scene::Description scene;  // with its meshes loaded
  sim::HandScript hand;
  double seconds = 4.0;
};

/// A run of the simulated arm under the servo, without a thread.
struct Run {
  int rate_hz = 1000;
  std::vector<Vec3> p_WT;   // where the tip truly was, tick by tick
  std::vector<Vec3> f_T_W;  // the force sent then
  lab::Cost tick, arm;      // of the servo's tick, and of the simulated arm, a period each
  bool faulted = false;     // it ended early
};

/// exact: the angles are not through the encoders. Problems: those of the scene with these settings (a closed form that
/// there is not, say).
Result<Run> run(const Bench& bench, const Settings& settings, bool exact = false);

/// The joints along a hand's way as the arm shows them, each with its time.
using Way = std::vector<arm::Sample>;

/// Where the hand itself is, as far as the arm follows. at_s: times of the ticks, rising; encoders: the joints come in
/// steps.
Way wayOf(const Bench& bench, const std::vector<double>& at_s, bool encoders);

/// What the tick finds where the hand itself is, not the arm: the same places whatever is found.
struct Walk {
  // Constraint by constraint, tick by tick:
  std::vector<std::vector<Vec3>> p_WP;  // the tip's place where none is unique
  std::vector<std::vector<Vec3>> e_W;   // the error, m
  std::vector<std::vector<double>> distance_m;
  std::vector<std::vector<Vec3>> rate_W;  // of the error, m/s; empty where no law damps
  std::vector<std::vector<bool>> acts;    // a target was there, and had been a tick before
  lab::Cost tick;                         // of those in which a target acts
};

/// Problems: those of the scene with these settings.
Result<Walk> walk(const Bench& bench, const Settings& settings, const Way& way);

/// 0 to the bench's seconds, evenly.
std::vector<double> timesOf(const Bench& bench, int rate_hz);

/// How far two runs are apart at the times of the slower one. Where fine has no tick at such a time it is on the line
/// between its two: at 16 kHz and 30 m/s^2, the most that the hands do, that is off by 1.5e-5 mm.
struct Apart {
  double rms_m = 0.0, most_m = 0.0;  // of the tips, root of the mean square and largest
  double rms_N = 0.0;                // of the forces
};
/// Of runs of the same bench, fine at no lower a rate than coarse. One of them without ticks: all 0.
Apart apart(const Run& coarse, const Run& fine);

}  // namespace underact::trade
