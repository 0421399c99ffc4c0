#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::curve {

/// Four boxes, axis by axis, so that a node is read from adjacent cache lines. Floats relative to the tree's own
/// origin, widened so that each box holds its contents after rounding.
struct alignas(32) Node {
  std::array<std::array<float, 4>, 3> low_O;
  std::array<std::array<float, 4>, 3> high_O;
};

/// A tree over pieces in the order of the curve, which needs no index, since neighbours along a curve are neighbours in
/// space. The children of node i of a level are the nodes (at the bottom: the pieces) 4 i to 4 i + 3 of the next.
struct Boxes {
  static constexpr int kMaxLevels = 15;  // 4^15 pieces
  Vec3 p_WO = Vec3::Zero();
  int levels = 0;
  std::array<std::int32_t, kMaxLevels> begins{};      // of each level in nodes, the root's first
  std::array<std::int32_t, kMaxLevels + 1> counts{};  // of each level; behind the bottom: of pieces
  std::vector<Node> nodes;
};

/// The tree over pieces of `stride` + 1 controls each, neighbours sharing one; a piece lies in the box of its controls.
/// controls_W: finite, m; at least one piece.
Boxes makeBoxes(const std::vector<Vec3>& controls_W, int stride);

/// The squared distances of q_O from the four boxes of a node; each within a relative 1e-15.
inline std::array<double, 4> squaredDistances(const Node& node, const Vec3& q_O) noexcept UNDERACT_REAL_TIME {
  std::array<double, 4> squares{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double q = q_O[static_cast<Eigen::Index>(axis)];
    for (std::size_t i = 0; i < 4; ++i) {
      const double below = static_cast<double>(node.low_O[axis][i]) - q;
      const double above = q - static_cast<double>(node.high_O[axis][i]);
      const double off = below > 0.0 ? below : above > 0.0 ? above : 0.0;
      squares[i] += off * off;
    }
  }
  return squares;
}

}  // namespace underact::curve
