#pragma once
#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/mesh/node.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace underact::mesh {

/// Lower bounds of the squared distance to the children's boxes. nearer: bit k is set where that of box k may be below
/// the limit.
struct alignas(16) BoxBounds {
  std::array<float, kChildren> squared;
  unsigned nearer = 0;
};

/// In floats: the position of q in the frame is off by 3e-7 of its distance and of the box's size; the boxes are wider
/// by more than the latter, and a factor allows for the former. limit: of the squared distance; boxes without a child
/// are infinitely far.
[[gnu::always_inline]] inline BoxBounds boundsOf(const Node& node, const Vec3& q_M,
                                                 double limit) noexcept UNDERACT_REAL_TIME {
  constexpr float kNearer = 1.0F - 0x1p-18F, kUp = 1.0F + 0x1p-17F;
  constexpr double kMin = 0x1p-120;  // below it floats lose precision, and no box could be nearer
  const float max = kUp * static_cast<float>(limit > kMin ? limit : kMin);
  BoxBounds bounds;
#if defined(__SSE2__)  // the same operations, four at a time
  // Four floats are read where three are needed; those after them belong to the node, too.
  const __m128 p_MN = _mm_loadu_ps(node.p_MN.data());
  const __m128d xy = _mm_sub_pd(_mm_loadu_pd(q_M.data()), _mm_cvtps_pd(p_MN));
  const __m128d z = _mm_sub_sd(_mm_load_sd(q_M.data() + 2), _mm_cvtps_pd(_mm_movehl_ps(p_MN, p_MN)));
  const __m128 p_xy = _mm_cvtpd_ps(xy), p_z = _mm_cvtpd_ps(z);
  const auto along = [&](std::size_t axis, __m128 length) noexcept UNDERACT_REAL_TIME {
    return _mm_mul_ps(_mm_loadu_ps(node.R_MN.data() + 3 * axis), length);
  };
  const __m128 at =
      _mm_add_ps(_mm_add_ps(along(0, _mm_shuffle_ps(p_xy, p_xy, 0x00)), along(1, _mm_shuffle_ps(p_xy, p_xy, 0x55))),
                 along(2, _mm_shuffle_ps(p_z, p_z, 0x00)));
  const __m128 x_N = _mm_shuffle_ps(at, at, 0x00), y_N = _mm_shuffle_ps(at, at, 0x55),
               z_N = _mm_shuffle_ps(at, at, 0xaa);
  const auto four = [&](std::size_t first) noexcept UNDERACT_REAL_TIME {
    const auto squared = [&](std::size_t axis, __m128 place) noexcept UNDERACT_REAL_TIME {
      const __m128 not_above = _mm_min_ps(place, _mm_load_ps(&node.high_N[axis][first]));
      const __m128 outside = _mm_sub_ps(place, _mm_max_ps(not_above, _mm_load_ps(&node.low_N[axis][first])));
      return _mm_mul_ps(outside, outside);
    };
    const __m128 sum = _mm_add_ps(_mm_add_ps(squared(0, x_N), squared(1, y_N)), squared(2, z_N));
    _mm_store_ps(&bounds.squared[first], _mm_mul_ps(_mm_set1_ps(kNearer), sum));
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(sum, _mm_set1_ps(max))));
  };
  static_assert(kChildren == 8);
  bounds.nearer = four(0) | four(4) << 4U;
#else
  const std::array<float, 3> p{static_cast<float>(q_M.x() - static_cast<double>(node.p_MN[0])),
                               static_cast<float>(q_M.y() - static_cast<double>(node.p_MN[1])),
                               static_cast<float>(q_M.z() - static_cast<double>(node.p_MN[2]))};
  std::array<float, 3> at;
  for (std::size_t axis = 0; axis < 3; ++axis)
    at[axis] = node.R_MN[axis] * p[0] + node.R_MN[3 + axis] * p[1] + node.R_MN[6 + axis] * p[2];
  for (std::size_t child = 0; child < kChildren; ++child) {
    float sum = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float low = node.low_N[axis][child], high = node.high_N[axis][child];
      const float not_above = at[axis] < high ? at[axis] : high;
      const float outside = at[axis] - (not_above > low ? not_above : low);
      sum += outside * outside;
    }
    bounds.squared[child] = kNearer * sum;
    bounds.nearer |= (sum < max ? 1U : 0U) << child;
  }
#endif
  return bounds;
}

/// Writes the children of the node that bounds leave to list, which has room for all. Gives how many they are. Without
/// a branch for each child, since such branches cannot be predicted.
[[gnu::always_inline]] inline std::size_t addChildren(const Node& node, unsigned nearer,
                                                      std::int32_t* list) noexcept UNDERACT_REAL_TIME {
  std::size_t size = 0;
#pragma GCC unroll 8
  for (std::size_t child = 0; child < kChildren; ++child) {
    list[size] = node.children[child];
    size += nearer >> child & 1U;
  }
  return size;
}

}  // namespace underact::mesh
