#pragma once
#include <algorithm>
#include <cmath>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact {

// Eigen's maxCoeff() and minCoeff() call through a function pointer, which the effect analysis cannot see through.

/// The largest absolute coordinate.
inline double largestOf(const Vec3& v) noexcept UNDERACT_REAL_TIME {
  return std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
}

/// The smallest coordinate, with its sign.
inline double minOf(const Vec3& v) noexcept UNDERACT_REAL_TIME {
  return std::min({v.x(), v.y(), v.z()});
}

}  // namespace underact
