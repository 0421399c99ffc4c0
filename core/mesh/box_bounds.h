#pragma once
#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/mesh/node.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace underact::mesh {

/// No point of box k is nearer to the point asked than the root of squared[k]; nearer has bit k where that may be below
/// the limit.
struct alignas(16) BoxBounds {
  std::array<float, kWays> squared;
  unsigned nearer = 0;
};

/// In floats: the place of q in the frame is off by 3e-7 of its distance and of the box's size; the boxes are wider by
/// more than the latter, a factor takes off the former. limit: of the squared distance; boxes without a child are
/// infinitely far.
[[gnu::always_inline]] inline BoxBounds boundsOf(const Node& node, const Vec3& q_M,
                                                 double limit) noexcept UNDERACT_REAL_TIME {
  constexpr float kNearer = 1.0F - 0x1p-18F, kUp = 1.0F + 0x1p-22F;
  const auto x = static_cast<float>(q_M.x() - static_cast<double>(node.p_MN[0]));
  const auto y = static_cast<float>(q_M.y() - static_cast<double>(node.p_MN[1]));
  const auto z = static_cast<float>(q_M.z() - static_cast<double>(node.p_MN[2]));
  const float most = kUp * static_cast<float>(limit);
  std::array<float, 3> at;
  for (std::size_t axis = 0; axis < 3; ++axis)
    at[axis] = node.R_NM[3 * axis] * x + node.R_NM[3 * axis + 1] * y + node.R_NM[3 * axis + 2] * z;
  BoxBounds bounds;
#if defined(__SSE2__)  // the same operations, four at a time
  const __m128 x_N = _mm_set1_ps(at[0]), y_N = _mm_set1_ps(at[1]), z_N = _mm_set1_ps(at[2]), none = _mm_setzero_ps();
  const auto four = [&](std::size_t first) noexcept UNDERACT_REAL_TIME {
    const auto squared = [&](std::size_t axis, __m128 place) noexcept UNDERACT_REAL_TIME {
      const __m128 below = _mm_sub_ps(_mm_load_ps(&node.low_N[axis][first]), place);
      const __m128 above = _mm_sub_ps(place, _mm_load_ps(&node.high_N[axis][first]));
      const __m128 outside = _mm_max_ps(_mm_max_ps(below, above), none);
      return _mm_mul_ps(outside, outside);
    };
    const __m128 sum = _mm_add_ps(_mm_add_ps(squared(0, x_N), squared(1, y_N)), squared(2, z_N));
    const __m128 bound = _mm_mul_ps(_mm_set1_ps(kNearer), sum);
    _mm_store_ps(&bounds.squared[first], bound);
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(bound, _mm_set1_ps(most))));
  };
  static_assert(kWays == 8);
  bounds.nearer = four(0) | four(4) << 4U;
#else
  for (std::size_t child = 0; child < kWays; ++child) {
    float sum = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float below = node.low_N[axis][child] - at[axis], above = at[axis] - node.high_N[axis][child];
      const float larger = below > above ? below : above, outside = larger > 0.0F ? larger : 0.0F;
      sum += outside * outside;
    }
    bounds.squared[child] = kNearer * sum;
    bounds.nearer |= (bounds.squared[child] < most ? 1U : 0U) << child;
  }
#endif
  return bounds;
}

}  // namespace underact::mesh
