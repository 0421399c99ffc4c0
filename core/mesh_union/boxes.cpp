#include "core/mesh_union/boxes.h"

#include <algorithm>
#include <numeric>

namespace underact::mesh_union {
namespace {

constexpr std::int32_t kInLeaf = 4;

void widen(Box& box, const Box& by) {
  box.low = box.low.min(by.low);
  box.high = box.high.max(by.high);
}

}  // namespace

Boxes::Boxes(const std::vector<GridPoint>& points, const std::vector<mesh::Face>& faces) : boxes_(faces.size()) {
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const auto at = [&](std::size_t k) {
      const GridPoint& p = points[static_cast<std::size_t>(faces[face][k])];
      return Eigen::Array3f(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
    };
    boxes_[face].low = at(0).min(at(1)).min(at(2));
    boxes_[face].high = at(0).max(at(1)).max(at(2));
  }
  order_.resize(faces.size());
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(faces.size());
  if (!faces.empty()) grow(0, static_cast<std::int32_t>(faces.size()));
}

void Boxes::grow(std::int32_t begin, std::int32_t end) {
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  Box box = boxOf(begin);
  for (std::int32_t place = begin + 1; place < end; ++place) widen(box, boxOf(place));
  nodes_[index] = {box, begin, end, -1};
  if (end - begin <= kInLeaf) return;
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const std::int32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::int32_t a, std::int32_t b) {
                     const auto centre = [&](std::int32_t face) {
                       const Box& one = boxes_[static_cast<std::size_t>(face)];
                       return one.low[axis] + one.high[axis];
                     };
                     return centre(a) != centre(b) ? centre(a) < centre(b) : a < b;
                   });
  grow(begin, middle);
  nodes_[index].second = static_cast<std::int32_t>(nodes_.size());
  grow(middle, end);
}

bool Boxes::isMet(const Box& box, const Vec3& from, const Vec3& along) {
  double first = 0.0, last = kInfinity;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double low = static_cast<double>(box.low[axis]) - 1.0 - from[axis],
                 high = static_cast<double>(box.high[axis]) + 1.0 - from[axis];
    if (along[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    const double to_low = low / along[axis], to_high = high / along[axis];
    first = std::max(first, std::min(to_low, to_high));
    last = std::min(last, std::max(to_low, to_high));
  }
  return first <= last;
}

}  // namespace underact::mesh_union
