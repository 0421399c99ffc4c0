#pragma once
#include <cstddef>
#include <vector>

#include "core/arm/mirror.h"
#include "core/arm/preset.h"
#include "core/arm/sample.h"
#include "core/base/types.h"

namespace underact::ghost {

/// The pose of a recorded stylus: its tip G, m, and the direction from there to the hand, of length 1.
struct StylusPose {
  Vec3 p_WG = Vec3::Zero();
  Vec3 stylus_W = Vec3::UnitZ();
};

/// A moment of the trajectory; time_s: since its beginning.
struct TrajectoryRow {
  double time_s = 0.0;
  StylusPose place;
  bool begins_anew = false;  // there is a gap before this row
};

/// The trajectory of a recorded hand, at most 250 rows a second. Made by TrajectoryBuilder: one row or more, rising
/// times, finite positions.
struct Trajectory {
  std::vector<TrajectoryRow> rows;
  int jumps = 0;  // how often the stylus jumps by more than kJump_m
  /// From the beginning to the last row; 0 without rows.
  double duration_s() const { return rows.empty() ? 0.0 : rows.back().time_s; }
};

inline constexpr double kRowsPerSecond = 250.0;  // a hand that moves at 0.5 m/s goes 2 mm between two
inline constexpr double kJump_m = 0.005;

/// Builds a trajectory from recorded joint angles, tick by tick.
class TrajectoryBuilder {
 public:
  /// rate_hz: of the ticks, above 0.
  TrajectoryBuilder(const arm::Geometry& geometry, double rate_hz);
  /// Adds a tick. begins_anew: the recording has a gap before it. Joint angles that are not finite keep their last
  /// value.
  void add(const arm::JointAngles& q_rad, bool begins_anew);
  /// The trajectory so far, moved out. No ticks: no rows.
  Trajectory take();

 private:
  void keep();

  arm::Geometry geometry_;
  double rate_hz_;
  std::size_t ticks_a_row_;
  std::size_t tick_ = 0, due_ = 0;  // of the next one to come; of the next one to keep
  TrajectoryRow last_;
  bool has_last_ = false;
  Trajectory trajectory_;
};

/// The trajectory reflected across the plane of its arm, for a stylus in the other hand. Twice is the original.
Trajectory mirrored(Trajectory trajectory, const arm::MirrorPlane& plane);

/// The pose of the stylus at a time of the trajectory, clamped to it; interpolated linearly between two rows, except
/// across a gap, where it stays at the first. way: of one row or more. Not finite in: the beginning. Cost: logarithmic
/// in the rows.
StylusPose poseAt(const Trajectory& trajectory, double time_s);

/// The path of the tip from time_s on for ahead_s, in `count` even steps (2 at least); it ends at a gap, and at the
/// end.
std::vector<Vec3> ahead(const Trajectory& trajectory, double time_s, double ahead_s, std::size_t count);

}  // namespace underact::ghost
