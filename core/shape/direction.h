#pragma once
#include <optional>

#include "core/base/norms.h"
#include "core/base/types.h"

namespace underact::shape {

/// The unit vector of a vector of length 1e-300 to 1e300; none where it is zero or not finite.
inline std::optional<Vec3> unitOf(const Vec3& vector) {
  const double largest = largestOf(vector);
  if (!(vector.allFinite() && largest > 0.0)) return std::nullopt;
  return (vector / largest).normalized();
}

}  // namespace underact::shape
