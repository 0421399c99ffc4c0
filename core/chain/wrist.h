#pragma once
#include <array>
#include <optional>
#include <span>

#include "core/base/real_time.h"
#include "core/base/units.h"
#include "core/chain/chain.h"

namespace underact::chain {

// Inside the room: three revolute axes that meet, and steps of an inverse with two solutions.

inline constexpr double kOutsideShare = 1e-9;  // so far outside counts as on the boundary; of the reach, or rad
inline constexpr double kMergedShare = 1e-12;  // and so far inside; a hundred times the rounding

/// The two solutions of a step: middle + half (+1) and middle - half (-1), or one where they coincide.
struct Branches {
  double middle_rad = 0.0;
  double half_rad = 0.0;
  bool merged = false;
  bool exact = true;
  /// 1 where they coincide.
  int count() const noexcept UNDERACT_REAL_TIME { return merged ? 1 : 2; }
  /// The angle of branch +1 or -1, rad.
  double answer(int branch) const noexcept UNDERACT_REAL_TIME { return middle_rad + branch * half_rad; }
};

/// The sum of two angles of (-pi, pi], in (-pi, pi] again.
inline double wrappedOnce(double angle_rad) noexcept UNDERACT_REAL_TIME {
  if (angle_rad > kPi) angle_rad -= 2.0 * kPi;
  if (angle_rad <= -kPi) angle_rad += 2.0 * kPi;
  return angle_rad;
}

/// The directions of the axes at home, neighbours not parallel.
struct WristAxes {
  std::array<Vec3, 3> axis_W;
  Vec3 across_W = Vec3::Zero();  // unit, across the last axis
  double middle_rad = 0.0;       // the second joint where the last axis is nearest to the first
};
/// Of three unit directions.
WristAxes wristAxes(const Vec3& first_W, const Vec3& second_W, const Vec3& third_W) noexcept;

/// The point in which three revolute joints' axes meet to within near_m; none where they do not, or where neighbours
/// are parallel, or one slides.
std::optional<Vec3> meetingPoint(std::span<const Joint, 3> joints, double near_m) noexcept;

/// The task of the wrist: where its last axis, and the line across that, shall point.
struct WristTask {
  Vec3 axis_6_W;
  Vec3 across_W;
};

/// The angles of the three joints, in (-pi, pi].
struct WristAnswer {
  std::array<double, 3> q{};
};
/// Both, or the one that is left where they coincide.
struct WristAnswers {
  std::array<WristAnswer, 2> all{};
  int count = 0;
  bool exact = true;  // false: the axes' angles do not allow the orientation, and these come nearest
};
/// Both solutions, the one with the second joint in the positive sense from its middle first. Where the first and last
/// axes are in line, the first joint is 0. Source: Elias and Wen 2022, "IK-Geo", subproblems 4 and 1.
WristAnswers solveWrist(const WristAxes& wrist, const WristTask& task) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
