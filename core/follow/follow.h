#pragma once
#include <cstdint>
#include <optional>

#include "core/follow/way.h"

namespace underact::follow {

/// How the ghost behaves, a stylus that repeats a recorded motion.
struct Options {
  bool plays = true;              // false: it stands still, and nothing counts
  double speed = 1.0;             // times the recorded one, kSlowest to kFastest
  bool loops = false;             // after its end it begins again
  bool begins_near = true;        // it stands at its beginning until the tip has come within kNear_m
  bool waits = true;              // it stands still while the tip is farther away than waits_beyond_m,
  double waits_beyond_m = 0.020;  // and goes on when it has come to within half of that
};

inline constexpr double kSlowest = 0.1, kFastest = 2.0;
inline constexpr double kNear_m = 0.010;  // "with it": counted, and where the beginning is reached

/// Ready: at its beginning, until the tip is there. Waiting: the tip was too far away.
enum class Phase : std::uint8_t { Ready, Going, Waiting, Ended };

/// How near the tip was while the ghost went; times are the hand's, whatever the ghost's speed.
struct Tally {
  double followed_s = 0.0;
  double waited_s = 0.0;  // not followed
  double near_s = 0.0;    // of those followed, within kNear_m
  double sum_m_s = 0.0;   // of distances
  double largest_m = 0.0;
  /// The mean distance over the time followed; 0 where nothing was followed.
  double mean_m() const { return followed_s > 0.0 ? sum_m_s / followed_s : 0.0; }
  /// The share of the time followed that the tip was within kNear_m, 0 to 1.
  double nearShare() const { return followed_s > 0.0 ? near_s / followed_s : 0.0; }
};

/// Where the ghost is, and how the hand has done.
struct State {
  Phase phase = Phase::Ready;
  double time_s = 0.0;  // of the way
  Place ghost;
  double distance_m = 0.0;              // from the tip to the ghost's
  Tally tally;                          // of this round
  std::optional<Tally> last_round;      // that came to its end
  int rounds = 0;                       // that did
  std::optional<std::int64_t> tick_ns;  // of the tick seen last
};

/// One tick on. time_ns: of the tick, by the arm's clock: steps back, and those longer than a quarter of a second, take
/// the ghost nowhere. p_WT: the tip; not finite: the state stays as it is. way: of two rows or more. The same ticks
/// give the same states, whatever the machine. Cost: as placeAt().
State advanced(const Way& way, const Options& options, State state, std::int64_t time_ns, const Vec3& p_WT);

}  // namespace underact::follow
