#include "core/curve/boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace underact::curve {
namespace {

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

float roundedDown(double x) {
  const float f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, -kFloatInfinity) : f;
}
float roundedUp(double x) {
  return -roundedDown(-x);
}

struct Box {
  std::array<float, 3> low{kFloatInfinity, kFloatInfinity, kFloatInfinity};
  std::array<float, 3> high{-kFloatInfinity, -kFloatInfinity, -kFloatInfinity};
};

Box boxOfPiece(const Vec3* controls_W, int stride, const Vec3& p_WO) {
  Box box;
  for (int k = 0; k <= stride; ++k) {
    const Vec3 p_O = controls_W[k] - p_WO;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = p_O[static_cast<Eigen::Index>(axis)];
      box.low[axis] = std::min(box.low[axis], roundedDown(x));
      box.high[axis] = std::max(box.high[axis], roundedUp(x));
    }
  }
  return box;
}

Box boxOfNode(const Node& node) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = *std::min_element(node.low_O[axis].begin(), node.low_O[axis].end());
    box.high[axis] = *std::max_element(node.high_O[axis].begin(), node.high_O[axis].end());
  }
  return box;
}

Box boundsOf(const std::vector<Vec3>& controls_W, int stride, const Boxes& boxes, std::size_t level, std::int32_t i) {
  if (i >= boxes.counts[level]) return {};  // does not exist: infinitely far away
  if (level < static_cast<std::size_t>(boxes.levels)) {
    return boxOfNode(boxes.nodes[static_cast<std::size_t>(boxes.begins[level] + i)]);
  }
  return boxOfPiece(&controls_W[static_cast<std::size_t>(i) * static_cast<std::size_t>(stride)], stride, boxes.p_WO);
}

/// The number of nodes of each level, from the root down; four of them are one of the level above.
void layOut(std::int32_t pieces, Boxes& boxes) {
  std::vector<std::int32_t> counts{pieces};
  do counts.push_back((counts.back() + 3) / 4);
  while (counts.back() > 1);
  boxes.levels = static_cast<int>(counts.size()) - 1;
  std::copy(counts.rbegin(), counts.rend(), boxes.counts.begin());
  std::int32_t begin = 0;
  for (std::size_t level = 0; level + 1 < counts.size(); ++level) {
    boxes.begins[level] = begin;
    begin += boxes.counts[level];
  }
  boxes.nodes.resize(static_cast<std::size_t>(begin));
}

}  // namespace

Boxes makeBoxes(const std::vector<Vec3>& controls_W, int stride) {
  Boxes boxes;
  Vec3 low_W = controls_W.front(), high_W = controls_W.front();
  for (const Vec3& p_W : controls_W) {
    low_W = low_W.cwiseMin(p_W);
    high_W = high_W.cwiseMax(p_W);
  }
  boxes.p_WO = 0.5 * (low_W + high_W);
  layOut(static_cast<std::int32_t>((controls_W.size() - 1) / static_cast<std::size_t>(stride)), boxes);
  for (int bottom = boxes.levels - 1; bottom >= 0; --bottom) {
    const auto level = static_cast<std::size_t>(bottom);
    for (std::int32_t i = 0; i < 4 * boxes.counts[level]; ++i) {
      const Box box = boundsOf(controls_W, stride, boxes, level + 1, i);
      Node& node = boxes.nodes[static_cast<std::size_t>(boxes.begins[level] + i / 4)];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.low_O[axis][static_cast<std::size_t>(i % 4)] = box.low[axis];
        node.high_O[axis][static_cast<std::size_t>(i % 4)] = box.high[axis];
      }
    }
  }
  return boxes;
}

}  // namespace underact::curve
