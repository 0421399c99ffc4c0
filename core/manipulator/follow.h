#pragma once
#include "core/manipulator/descend.h"

namespace underact::manipulator {

/// A second descent that looks for better minima, a step every few ticks.
struct Watch {
  Values theta{};
  std::uint64_t random = 1;  // where the next start is drawn from
  int steps = 0;             // of this start
  int ticks = 0;             // until its next step
  double better_s = 0.0;     // for how long it has been better by the margin
  bool begun = false;
};

/// All memory between two ticks.
struct State {
  Values theta{};
  Values pace{};             // how far the joints went in the last tick
  Vec3 p_WP = Vec3::Zero();  // the last target
  bool begun = false;
  bool lost = false;  // a cold start found that nothing says where the tip is
  Watch watch;
};

/// Of bytes from a file.
bool isSound(const State& state) noexcept;

/// Where the tip is this tick, and what was found out.
struct Followed {
  Vec3 p_WP = Vec3::Zero();  // the target: the tip, or on the way to it
  Energy at;                 // at the joints of this tick
  int steps = 0;
  double left = 0.0;                // what a joint would still move by itself, rad or shares of the reach: above the
                                    // tolerance where the steps did not suffice
  bool is_unique = true;            // false: every place is as good and there is no past; p_WP is the stylus
  bool slewing = false;             // the target is on its way to the tip
  double better_J = 0.0;            // what another minimum is known to save; 0: none is known
  Vec3 f_along_T_W = Vec3::Zero();  // the thesis's law: what it adds to the pull towards the target
  Vec3 moment_W = Vec3::Zero();     // on the hand about the stylus's tip, N m; never sent
};

/// The target never moves faster than this, so that a minimum that vanishes or is left for a better one is no blow: at
/// 0.5 N/mm the force grows by 1 N/ms at most.
inline constexpr double kSlew_m_per_s = 2.0;
/// Another minimum is better when it saves a tenth of the energy and a hundredth of a millijoule; it is taken once it
/// has been for this long.
inline constexpr double kBetterShare = 0.1;
inline constexpr double kBetter_J = 1e-5;
inline constexpr double kBetterFor_s = 0.05;

/// One tick: from the last tick's joints, and as far on as they went then, down to the minimum they are in, or the
/// closed form; then the watch, then the slew. dt_s: since the last tick; 0: unknown. A first tick starts at home. A
/// stylus that is not finite has no target, and leaves the state as it was. Deterministic. Cost: at most max_steps + 1
/// steps of the solver.
Followed follow(const Manipulator& manipulator, const Pose& X_WT, double dt_s,
                State& state) noexcept UNDERACT_REAL_TIME;

/// A state that stands at the minimum of least energy (or where the thesis's law has its tip), for a lone pose; not for
/// the servo thread. steps: all it took.
State standing(const Manipulator& manipulator, const Pose& X_WT, int& steps);

}  // namespace underact::manipulator
