#pragma once
#include <array>

#include "core/base/real_time.h"
#include "core/mesh/surface.h"

namespace underact::mesh {

/// Faces that are bounded at once.
inline constexpr std::size_t kAtOnce = 4;

/// Lower bounds of the squared distances from q to the faces; a number that is not above 0 says nothing, as where the
/// angle at the first corner is acute or floats do not hold the products. Otherwise it is below the squared distance by
/// at most 2^-13 of it and 2^-14 of the longest edge squared. In floats, without a branch. q_M: finite.
std::array<float, kAtOnce> faceBounds(const Surface& surface, const std::array<std::int32_t, kAtOnce>& faces,
                                      const Vec3& q_M) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
