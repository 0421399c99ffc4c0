#pragma once
#include <cstdint>
#include <optional>

#include "core/ghost/trajectory.h"

namespace underact::ghost {

/// How the ghost behaves, a stylus that repeats a recorded motion.
struct Options {
  bool plays = true;              // false: it pauses, and nothing counts
  double speed = 1.0;             // times the recorded one, kSlowest to kFastest
  bool loops = false;             // it starts again at its end
  bool begins_near = true;        // it waits at its beginning until the tip is within kNear_m
  bool waits = true;              // it waits while the tip is farther away than waits_beyond_m,
  double waits_beyond_m = 0.020;  // and continues when it is within half of that
};

inline constexpr double kSlowest = 0.1, kFastest = 2.0;
inline constexpr double kNear_m = 0.010;  // "with it": counts as near, and reaches the beginning

/// Ready: at its beginning, until the tip is there. Waiting: the tip was too far away.
enum class Phase : std::uint8_t { Ready, Going, Waiting, Ended };

/// How near the tip was while the ghost moved; times are real, whatever the ghost's speed.
struct Tally {
  double followed_s = 0.0;
  double waited_s = 0.0;  // not followed
  double near_s = 0.0;    // of the time followed, within kNear_m
  double sum_m_s = 0.0;   // of distances
  double largest_m = 0.0;
  /// The mean distance over the time followed; 0 where nothing was followed.
  double mean_m() const { return followed_s > 0.0 ? sum_m_s / followed_s : 0.0; }
  /// The share of the time followed that the tip was within kNear_m, 0 to 1.
  double nearShare() const { return followed_s > 0.0 ? near_s / followed_s : 0.0; }
};

/// The state of the ghost, and how well the hand has followed it.
struct State {
  Phase phase = Phase::Ready;
  double time_s = 0.0;  // of the way
  StylusPose ghost;
  double distance_m = 0.0;              // from the tip to the ghost's
  Tally tally;                          // of this round
  std::optional<Tally> last_round;      // that came to its end
  int rounds = 0;                       // that did
  std::optional<std::int64_t> tick_ns;  // of the tick seen last
};

/// The state after a tick. time_ns: of the tick, by the arm's clock; steps back, and steps longer than a quarter of a
/// second, do not move the ghost. p_WT: the tip; not finite: the state stays. way: of two rows or more. The same ticks
/// give the same states on every machine. Cost: as poseAt().
State advanced(const Trajectory& trajectory, const Options& options, State state, std::int64_t time_ns,
               const Vec3& p_WT);

}  // namespace underact::ghost
