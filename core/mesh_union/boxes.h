#pragma once
#include <vector>

#include "core/mesh_union/grid.h"

namespace underact::mesh_union {

/// Bounds in steps of the grid, rounded outwards to floats.
struct Box {
  Eigen::Array3f low = Eigen::Array3f::Constant(kNotANumber), high = low;
};
/// Whether two boxes have a point in common.
inline bool meet(const Box& a, const Box& b) {
  return (a.low <= b.high).all() && (b.low <= a.high).all();
}

/// A tree of bounding boxes over faces.
class Boxes {
 public:
  /// faces: of these points. Cost: n log n.
  Boxes(const std::vector<GridPoint>& points, const std::vector<mesh::Face>& faces);

  /// Calls visit(a, b) once for each pair of faces whose boxes meet; ends if it returns false.
  template <class Visit>
  void eachPair(const Visit& visit) const {
    std::vector<std::array<std::int32_t, 2>> waiting;
    if (!nodes_.empty()) waiting.push_back({0, 0});
    while (!waiting.empty()) {
      const auto [a, b] = waiting.back();
      waiting.pop_back();
      const Node &one = at(a), &other = at(b);
      if (a != b && !meet(one.box, other.box)) continue;
      if (one.second < 0 && other.second < 0) {
        for (std::int32_t i = one.begin; i < one.end; ++i) {
          for (std::int32_t j = a == b ? i + 1 : other.begin; j < other.end; ++j) {
            if (meet(boxOf(i), boxOf(j)) && !visit(faceAt(i), faceAt(j))) return;
          }
        }
      } else if (a == b) {
        waiting.push_back({a + 1, a + 1});
        waiting.push_back({one.second, one.second});
        waiting.push_back({a + 1, one.second});
      } else if (other.second < 0 || (one.second >= 0 && one.end - one.begin >= other.end - other.begin)) {
        waiting.push_back({a + 1, b});
        waiting.push_back({one.second, b});
      } else {
        waiting.push_back({a, b + 1});
        waiting.push_back({a, other.second});
      }
    }
  }

  /// Calls visit(face) for each face whose box is met by the ray from a point.
  template <class Visit>
  void alongRay(const Vec3& from, const Vec3& along, const Visit& visit) const {
    std::vector<std::int32_t> waiting;
    if (!nodes_.empty()) waiting.push_back(0);
    while (!waiting.empty()) {
      const std::int32_t index = waiting.back();
      waiting.pop_back();
      const Node& node = at(index);
      if (!isMet(node.box, from, along)) continue;
      if (node.second < 0) {
        for (std::int32_t i = node.begin; i < node.end; ++i) visit(faceAt(i));
      } else {
        waiting.push_back(index + 1);
        waiting.push_back(node.second);
      }
    }
  }

 private:
  struct Node {  // the first child follows it
    Box box;
    std::int32_t begin = 0, end = 0;  // of the order
    std::int32_t second = -1;         // child; -1: it has none
  };
  const Node& at(std::int32_t node) const { return nodes_[static_cast<std::size_t>(node)]; }
  std::int32_t faceAt(std::int32_t place) const { return order_[static_cast<std::size_t>(place)]; }
  const Box& boxOf(std::int32_t place) const { return boxes_[static_cast<std::size_t>(faceAt(place))]; }
  static bool isMet(const Box& box, const Vec3& from, const Vec3& along);
  void grow(std::int32_t begin, std::int32_t end);
  std::vector<Box> boxes_;
  std::vector<std::int32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace underact::mesh_union
