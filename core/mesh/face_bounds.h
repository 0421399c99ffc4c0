#pragma once
#include <array>

#include "core/base/real_time.h"
#include "core/mesh/surface.h"

namespace underact::mesh {

/// How many faces are looked at in one go.
inline constexpr std::size_t kAtOnce = 4;

/// No point of faces[k] is nearer to q than the root of the k-th number, or that is not above 0 and says nothing, as
/// where the angle at the first corner is sharp or floats do not hold the products. Else it lies below the squared
/// distance by 2^-13 of that and 2^-14 of the longest edge's square at most. In floats, without a branch. q_M: finite.
std::array<float, kAtOnce> faceBounds(const Surface& surface, const std::array<std::int32_t, kAtOnce>& faces,
                                      const Vec3& q_M) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
