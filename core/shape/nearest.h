#pragma once
#include <cstdint>

#include "core/base/norms.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::shape {

/// Whether there is one nearest point, within the rounding of the coordinates.
enum class Status : std::uint8_t { Unique, NotUnique };

/// The point P of a shape nearest to the tip T.
struct Nearest {
  Vec3 p_WP = Vec3::Zero();           // m; T itself where it is NotUnique, so that a law gives no force
  Status status = Status::NotUnique;  // NotUnique: several points are equally near
  double height_m = 0.0;              // distance from the shape; negative inside one that has sides
};

// Under this share of the coordinates it is their rounding, no longer the hand, that decides a direction.
inline constexpr double kDirectionLost = 0x1p-49;  // 8 epsilon
// Below this length the square of a coordinate is not a normal number.
inline constexpr double kTooShort_m = 1e-150;

/// Whether the tip is on an axis through p_WC within rounding, off_axis_m from it. The rounding is that of p_WT and
/// p_WC too, not of their difference alone: a coordinate given in mm is seldom exact in m.
inline bool isOnAxis(double off_axis_m, const Vec3& p_WC, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME {
  return off_axis_m <= kDirectionLost * std::max(largestOf(p_WC), largestOf(p_WT)) || off_axis_m <= kTooShort_m;
}

}  // namespace underact::shape
