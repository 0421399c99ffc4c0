#include "core/mesh/tree.h"

#include <algorithm>
#include <bit>
#include <future>
#include <numeric>

#include "core/mesh/box_frame.h"
#include "core/mesh/in_parallel.h"

namespace underact::mesh {
namespace {

constexpr auto kInBottom = static_cast<std::int32_t>(kChildren);  // faces of a leaf
constexpr std::int32_t kWorthAThread = 50'000;                    // faces
using Centre = Eigen::Vector3f;                                   // three times the centroid; only its order counts

struct Range {
  std::int32_t begin, end;  // of the order
  std::int32_t size() const { return end - begin; }
};

/// The first part of a range larger than a leaf: so that all leaves but the last are full.
Range firstPart(const Range& range) {
  const std::int32_t eighths = (range.size() + 2 * kInBottom - 1) / (2 * kInBottom);
  return {range.begin, range.begin + kInBottom * eighths};
}

class Splitter {
 public:
  Splitter(const Triangles& triangles, const TaskMonitor& monitor) : watch_(monitor), centres_(triangles.faces.size()) {
    order_.resize(triangles.faces.size());
    std::iota(order_.begin(), order_.end(), 0);
    for (std::size_t face = 0; face < centres_.size(); ++face) {
      const Face& f = triangles.faces[face];
      const auto at = [&](std::size_t k) { return triangles.p_MV[static_cast<std::size_t>(f[k])]; };
      centres_[face] = at(0) + at(1) + at(2);
    }
  }
  std::vector<std::int32_t> split() {
    split({0, static_cast<std::int32_t>(order_.size())});
    return std::move(order_);
  }

 private:
  void split(const Range& range) {
    if (range.size() <= kInBottom || watch_.isCancelled()) return;
    Centre low = centreAt(range.begin), high = low;
    for (std::int32_t place = range.begin; place < range.end; ++place) {
      low = low.cwiseMin(centreAt(place));
      high = high.cwiseMax(centreAt(place));
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const Range first = firstPart(range);
    const auto before = [&](std::int32_t a, std::int32_t b) {  // equal ones by number: the same tree everywhere
      const float of_a = centres_[static_cast<std::size_t>(a)][axis],
                  of_b = centres_[static_cast<std::size_t>(b)][axis];
      return of_a != of_b ? of_a < of_b : a < b;
    };
    std::nth_element(order_.begin() + range.begin, order_.begin() + first.end, order_.begin() + range.end, before);
    const Range second{first.end, range.end};
    if (range.size() < kWorthAThread) {
      split(first);
      split(second);
      return;
    }
    std::future<void> other = std::async(std::launch::async, [&] { split(second); });
    split(first);
    other.wait();
  }
  const Centre& centreAt(std::int32_t place) const {
    return centres_[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])];
  }
  const TaskMonitor& watch_;
  std::vector<Centre> centres_;
  std::vector<std::int32_t> order_;
};

constexpr int kHalvings = std::countr_zero(kChildren);  // of a node's faces among its children

/// The parts of a range halved kHalvings times; what fits into a leaf stays together.
template <class Use>
void forParts(const Range& range, int halvings, const Use& use) {
  if (halvings == 0 || range.size() <= kInBottom) {
    use(range);
    return;
  }
  const Range first = firstPart(range);
  forParts(first, halvings - 1, use);
  forParts({first.end, range.end}, halvings - 1, use);
}

/// The positions of the nodes and the contents of their children.
class Layout {
 public:
  explicit Layout(std::int32_t faces) { place({0, faces}); }
  std::vector<Node> nodes;
  std::vector<std::array<Range, kChildren>> parts;  // of each node's children

 private:
  std::int32_t place(const Range& range) {
    const std::size_t index = nodes.size();
    nodes.emplace_back();
    parts.push_back({});
    nodes[index].children.fill(kNoChild);
    std::size_t child = 0;
    const auto add = [&](const Range& part, bool is_face) {
      parts[index][child] = part;
      const std::int32_t held = is_face ? -1 - part.begin : place(part);
      nodes[index].children[child++] = held;
    };
    if (range.size() <= kInBottom) {
      for (std::int32_t face = range.begin; face < range.end; ++face) add({face, face + 1}, true);
      return static_cast<std::int32_t>(index);
    }
    forParts(range, kHalvings, [&](const Range& part) { add(part, false); });
    return static_cast<std::int32_t>(index);
  }
};

}  // namespace

std::optional<Tree> makeTree(const Triangles& triangles, const TaskMonitor& monitor) {
  Tree tree{Splitter(triangles, monitor).split(), {}};
  if (monitor.isCancelled()) return {};
  Layout layout(static_cast<std::int32_t>(tree.order.size()));
  inParallel(layout.nodes.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Eigen::Vector3f> corners;
    std::array<std::size_t, kChildren + 1> begins{};
    for (std::size_t index = begin; index < end && !monitor.isCancelled(); ++index) {
      corners.clear();
      for (std::size_t child = 0; child < kChildren; ++child) {
        begins[child] = corners.size();
        const Range& part = layout.parts[index][child];
        for (std::int32_t place = part.begin; place < part.end; ++place) {
          const std::int32_t face = tree.order[static_cast<std::size_t>(place)];
          for (const std::int32_t corner : triangles.faces[static_cast<std::size_t>(face)])
            corners.push_back(triangles.p_MV[static_cast<std::size_t>(corner)]);
        }
      }
      begins[kChildren] = corners.size();
      setBoxes(corners, begins, layout.nodes[index]);
    }
  });
  if (monitor.isCancelled()) return {};
  tree.nodes = std::move(layout.nodes);
  return tree;
}

}  // namespace underact::mesh
