#include "core/mesh_file/holes.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace underact::mesh_file {
namespace {

constexpr std::size_t kMaxSteps = 20'000;  // of borders; looking for loops takes the square of the longest

/// From a corner to the next one, as the faces that close the hole go along it.
struct Step {
  std::int32_t from, to;
};

struct SidedEdge {
  std::int32_t low, high, forward;
};

/// What is left of all sides where they cancel two by two, turned round; in order.
std::vector<Step> bordersOf(const mesh::Triangles& triangles) {
  std::vector<SidedEdge> sides;
  sides.reserve(3 * triangles.faces.size());
  for (const mesh::Face& face : triangles.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t from = face[k], to = face[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const SidedEdge& a, const SidedEdge& b) {
    return std::tie(a.low, a.high, a.forward) < std::tie(b.low, b.high, b.forward);
  });
  std::vector<Step> steps;
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    std::int32_t sum = 0;
    for (; end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high; ++end)
      sum += sides[end].forward;
    for (; sum > 0; --sum) steps.push_back({sides[begin].high, sides[begin].low});
    for (; sum < 0; ++sum) steps.push_back({sides[begin].low, sides[begin].high});
    begin = end;
  }
  std::sort(steps.begin(), steps.end(),
            [](const Step& a, const Step& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  return steps;
}

/// Ways around that use each step once; as many steps come to a corner as leave it.
std::vector<std::vector<std::int32_t>> loopsOf(const std::vector<Step>& steps) {
  std::vector<std::uint8_t> is_used(steps.size(), 0);
  const auto firstFrom = [&](std::int32_t corner) {
    const auto first = std::lower_bound(steps.begin(), steps.end(), corner,
                                        [](const Step& step, std::int32_t at) { return step.from < at; });
    auto place = static_cast<std::size_t>(first - steps.begin());
    while (place < steps.size() && steps[place].from == corner && is_used[place] != 0) ++place;
    return place < steps.size() && steps[place].from == corner ? place : steps.size();
  };
  std::vector<std::vector<std::int32_t>> loops;
  for (std::size_t first = 0; first < steps.size(); ++first) {
    if (is_used[first] != 0) continue;
    std::vector<std::int32_t> path;
    for (std::size_t place = first; place < steps.size(); place = firstFrom(steps[place].to)) {
      is_used[place] = 1;
      const std::int32_t from = steps[place].from;
      // Where it comes back to a corner, what is between is a loop of its own.
      const auto again = std::find(path.begin(), path.end(), from);
      if (again != path.end()) {
        loops.emplace_back(again, path.end());
        path.erase(again, path.end());
      }
      path.push_back(from);
    }
    loops.push_back(std::move(path));
  }
  return loops;
}

double sizeOf(const mesh::Triangles& triangles, double& area) {
  Vec3 low = Vec3::Constant(kInfinity), high = -low;
  for (const mesh::Face& face : triangles.faces) {
    const Vec3 a = cornerAt(triangles, face[0]), b = cornerAt(triangles, face[1]), c = cornerAt(triangles, face[2]);
    low = low.cwiseMin(a).cwiseMin(b).cwiseMin(c);
    high = high.cwiseMax(a).cwiseMax(b).cwiseMax(c);
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return (high - low).norm();
}

}  // namespace

std::optional<ClosedHoles> closeHoles(mesh::Triangles& triangles, const TaskMonitor& monitor) {
  double area = 0.0, closed_area = 0.0;
  const double size = sizeOf(triangles, area);
  const std::vector<Step> borders = bordersOf(triangles);
  if (monitor.isCancelled() || borders.size() > kMaxSteps) return {};
  ClosedHoles closed;
  std::vector<mesh::Face> faces;
  std::vector<Eigen::Vector3f> middles;
  for (const std::vector<std::int32_t>& loop : loopsOf(borders)) {
    if (loop.size() < 3 || monitor.isCancelled()) return {};
    double around = 0.0;
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 at = cornerAt(triangles, loop[k]), next = cornerAt(triangles, loop[(k + 1) % loop.size()]);
      around += (next - at).norm();
      middle += at / static_cast<double>(loop.size());
    }
    if (around > kLongestHole * size) return {};
    const auto centre = static_cast<std::int32_t>(triangles.p_MV.size() + middles.size());
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 at = cornerAt(triangles, loop[k]), next = cornerAt(triangles, loop[(k + 1) % loop.size()]);
      closed_area += 0.5 * (at - middle).cross(next - middle).norm();
      if (loop.size() > 3) faces.push_back({loop[k], loop[(k + 1) % loop.size()], centre});
    }
    if (loop.size() == 3) {
      faces.push_back({loop[0], loop[1], loop[2]});
    } else {
      middles.push_back(middle.cast<float>());
    }
    ++closed.count;
    closed.longest = std::max(closed.longest, around);
  }
  if (closed_area > kMaxOfArea * area) return {};
  triangles.faces.insert(triangles.faces.end(), faces.begin(), faces.end());
  triangles.p_MV.insert(triangles.p_MV.end(), middles.begin(), middles.end());
  return closed;
}

}  // namespace underact::mesh_file
