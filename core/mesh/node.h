#pragma once
#include <array>
#include <cstdint>

namespace underact::mesh {

inline constexpr std::size_t kChildren = 8;

/// The index of a child that does not exist.
inline constexpr std::int32_t kNoChild = INT32_MIN;

/// Eight boxes, in the node's own frame N, which is aligned with its part of the surface: so they are thin, and a ball
/// that touches the surface intersects few of them. Floats, widened so that each box holds its faces after rounding.
struct alignas(32) Node {
  std::array<float, 9> R_MN;                          // row by row; a rotation within 1e-6
  std::array<float, 3> p_MN;                          // the frame's origin
  std::array<std::array<float, kChildren>, 3> low_N;  // axis by axis, of the children
  std::array<std::array<float, kChildren>, 3> high_N;
  std::array<std::int32_t, kChildren>
      children;  // a node, or below 0 the face -1 - child; kNoChild: none, from there on
};

}  // namespace underact::mesh
