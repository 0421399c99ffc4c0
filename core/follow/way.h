#pragma once
#include <cstddef>
#include <vector>

#include "core/arm/preset.h"
#include "core/arm/sample.h"
#include "core/base/types.h"

namespace underact::follow {

/// Where a stylus is that somebody else moves: its tip G, m, and the direction from there to the hand, of length 1.
struct Place {
  Vec3 p_WG = Vec3::Zero();
  Vec3 stylus_W = Vec3::UnitZ();
};

/// A moment of the way; time_s: since its beginning.
struct Row {
  double time_s = 0.0;
  Place place;
  bool begins_anew = false;  // nothing leads here from the row before
};

/// The way that a recorded hand went, at most 250 rows a second. Made by WayMaker: one row or more, times that rise,
/// places that are finite.
struct Way {
  std::vector<Row> rows;
  int jumps = 0;  // how often the stylus is elsewhere all at once, by more than kJump_m
  /// From the beginning to the last row; 0 without rows.
  double duration_s() const { return rows.empty() ? 0.0 : rows.back().time_s; }
};

inline constexpr double kRowsPerSecond = 250.0;  // a hand that moves at 0.5 m/s goes 2 mm between two
inline constexpr double kJump_m = 0.005;

/// Puts a way together out of the joints that were recorded, tick by tick.
class WayMaker {
 public:
  /// rate_hz: of the ticks, above 0.
  WayMaker(const arm::Geometry& geometry, double rate_hz);
  /// The next tick. begins_anew: the recording has a gap before it. Joints that are not finite stand still.
  void add(const arm::JointAngles& q_rad, bool begins_anew);
  /// What was added. No ticks: no rows.
  Way take();

 private:
  void keep();

  arm::Geometry geometry_;
  double rate_hz_;
  std::size_t ticks_a_row_;
  std::size_t tick_ = 0, due_ = 0;  // of the next one to come; of the next one to keep
  Row last_;
  bool has_last_ = false;
  Way way_;
};

/// The way as a mirror across the plane x = 0 of W shows it, for a stylus in the other hand. Twice is the way itself.
Way mirrored(Way way);

/// Where the stylus is at a time of the way, held within it; between two rows on the line from one to the other, but
/// where a gap lies between them it stays at the first. way: of one row or more. Not finite in: the beginning. Cost:
/// logarithmic in the rows.
Place placeAt(const Way& way, double time_s);

/// The tip's way from time_s on for ahead_s, in `count` even steps (2 at least); it ends at a gap, and at the end.
std::vector<Vec3> ahead(const Way& way, double time_s, double ahead_s, std::size_t count);

}  // namespace underact::follow
