#include "core/ghost/trajectory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/forward.h"

namespace underact::ghost {
namespace {

constexpr double kNoDirection = 1e-6;  // below this two directions are opposite, and any in between is as good

bool isFinite(const arm::JointAngles& q_rad) {
  return std::all_of(q_rad.begin(), q_rad.end(), [](double angle_rad) { return std::isfinite(angle_rad); });
}

StylusPose between(const StylusPose& from, const StylusPose& to, double share) {
  const Vec3 stylus_W = (1.0 - share) * from.stylus_W + share * to.stylus_W;
  const double length = stylus_W.norm();
  return {(1.0 - share) * from.p_WG + share * to.p_WG, length > kNoDirection ? Vec3(stylus_W / length) : from.stylus_W};
}

/// The first row after that time.
std::vector<TrajectoryRow>::const_iterator rowAfter(const Trajectory& trajectory, double time_s) {
  return std::upper_bound(trajectory.rows.begin(), trajectory.rows.end(), time_s,
                          [](double time, const TrajectoryRow& row) { return time < row.time_s; });
}

}  // namespace

TrajectoryBuilder::TrajectoryBuilder(const arm::Geometry& geometry, double rate_hz)
    : geometry_(geometry),
      rate_hz_(rate_hz),
      ticks_a_row_(static_cast<std::size_t>(std::max(1.0, std::ceil(rate_hz / kRowsPerSecond)))) {}

void TrajectoryBuilder::add(const arm::JointAngles& q_rad, bool begins_anew) {
  const StylusPose before = last_.place;
  last_.time_s = static_cast<double>(tick_) / rate_hz_;
  if (isFinite(q_rad)) {
    const Pose X_WG = arm::tipPose(geometry_, q_rad);
    last_.place = {X_WG.translation(), X_WG.linear().col(2)};
  }
  last_.begins_anew = begins_anew && has_last_;
  if (last_.begins_anew && (last_.place.p_WG - before.p_WG).norm() > kJump_m) ++trajectory_.jumps;
  has_last_ = true;
  if (tick_ >= due_ || last_.begins_anew) keep();
  ++tick_;
}

void TrajectoryBuilder::keep() {
  trajectory_.rows.push_back(last_);
  due_ = tick_ + ticks_a_row_;
}

Trajectory TrajectoryBuilder::take() {
  if (has_last_ && trajectory_.rows.back().time_s < last_.time_s)
    trajectory_.rows.push_back(last_);  // it ends where the hand did
  return std::move(trajectory_);
}

Trajectory mirrored(Trajectory trajectory, const arm::MirrorPlane& plane) {
  for (TrajectoryRow& row : trajectory.rows) {
    row.place.p_WG = plane.positionSeen(row.place.p_WG);
    row.place.stylus_W = plane.directionSeen(row.place.stylus_W);
  }
  return trajectory;
}

StylusPose poseAt(const Trajectory& trajectory, double time_s) {
  if (!(time_s > 0.0)) return trajectory.rows.front().place;
  const auto after = rowAfter(trajectory, time_s);
  if (after == trajectory.rows.end()) return trajectory.rows.back().place;
  const TrajectoryRow& before = *std::prev(after);
  if (after->begins_anew) return before.place;
  return between(before.place, after->place, (time_s - before.time_s) / (after->time_s - before.time_s));
}

std::vector<Vec3> ahead(const Trajectory& trajectory, double time_s, double ahead_s, std::size_t count) {
  const double from_s = std::clamp(time_s, 0.0, trajectory.duration_s());
  double to_s = std::min(from_s + ahead_s, trajectory.duration_s());
  const auto gap = std::find_if(rowAfter(trajectory, from_s), trajectory.rows.end(),
                                [to_s](const TrajectoryRow& row) { return row.begins_anew || row.time_s > to_s; });
  if (gap != trajectory.rows.end() && gap->begins_anew) to_s = std::min(to_s, std::prev(gap)->time_s);
  std::vector<Vec3> points;
  for (std::size_t step = 0; step < count && to_s > from_s; ++step) {
    const double share = static_cast<double>(step) / static_cast<double>(count - 1);
    points.push_back(poseAt(trajectory, from_s + share * (to_s - from_s)).p_WG);
  }
  return points;
}

}  // namespace underact::ghost
