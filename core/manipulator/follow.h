#pragma once
#include "core/manipulator/descend.h"

namespace underact::manipulator {

/// A second descent in search of a better minimum, one step every few ticks.
struct BackgroundSearch {
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
  bool lost = false;  // a cold start found no unique minimum
  BackgroundSearch background;
};

/// Of bytes from a file.
bool isValid(const State& state) noexcept;

/// Where the end effector is in this tick, and how it was found.
struct Followed {
  Vec3 p_WP = Vec3::Zero();  // the target: the end effector, or a point on the way to it
  Energy at;                 // at the joints of this tick
  int steps = 0;
  double left = 0.0;                // the largest joint step left, rad or shares of the reach: above the
                                    // tolerance where the steps did not suffice
  bool is_unique = true;            // false: all configurations are equal on a first tick; p_WP is the stylus
  bool slewing = false;             // the target is on its way to the tip
  double better_J = 0.0;            // what another known minimum would save; 0: none is known
  Vec3 f_along_T_W = Vec3::Zero();  // the thesis's law: what it adds to the pull towards the target
  Vec3 moment_W = Vec3::Zero();     // on the hand about the stylus's tip, N m; few arms render it
};

/// The target never moves faster than this, so that the change to another minimum is no jolt: at 0.5 N/mm the force
/// grows by at most 1 N/ms.
inline constexpr double kSlew_m_per_s = 2.0;
/// Another minimum is better when it saves a tenth of the energy and a hundredth of a millijoule; the robot goes over
/// to it once that has been so for kBetter_s.
inline constexpr double kBetterShare = 0.1;
inline constexpr double kBetter_J = 1e-5;
inline constexpr double kBetterFor_s = 0.05;

/// One tick: extrapolates the joints from the last tick and descends to the nearest minimum, or takes the closed form;
/// then a step of the second descent, then the slew limit. dt_s: since the last tick; 0: unknown. A first tick starts
/// at home. A stylus that is not finite has no target, and leaves the state as it was. Deterministic. Cost: at most
/// max_steps + 1 steps of the solver.
Followed follow(const Manipulator& manipulator, const Pose& X_WT, double dt_s,
                State& state) noexcept UNDERACT_REAL_TIME;

/// A state at the minimum of least energy (or where the thesis's law has its tip), for a single pose; not for the servo
/// thread. steps: all that it took.
State settledState(const Manipulator& manipulator, const Pose& X_WT, int& steps);

}  // namespace underact::manipulator
