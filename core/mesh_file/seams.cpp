#include "core/mesh_file/seams.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/mesh_file/steps.h"

namespace underact::mesh_file {
namespace {

using mesh::Face;
using mesh::Triangles;

constexpr std::int64_t kMaxCompared = 20'000'000;  // corners compared with borders, a tenth of a second

using Along = std::vector<std::int32_t>;  // corners on a side, from its start to its end

/// The corners of borders, in the order of a coordinate.
class BorderCorners {
 public:
  BorderCorners(const Triangles& triangles, const std::vector<Side>& borders, double tolerance)
      : triangles_(triangles), tolerance_(tolerance) {
    Vec3 low = Vec3::Constant(kInfinity), high = -low;
    for (const Side side : borders) {
      for (const std::int32_t corner : {startOf(triangles, side), endOf(triangles, side)}) {
        corners_.push_back(corner);
        low = low.cwiseMin(cornerAt(triangles, corner));
        high = high.cwiseMax(cornerAt(triangles, corner));
      }
    }
    (high - low).maxCoeff(&axis_);
    const auto before = [this](std::int32_t a, std::int32_t b) {
      return place(a) != place(b) ? place(a) < place(b) : a < b;
    };
    std::sort(corners_.begin(), corners_.end(), before);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
  }
  /// Those on the side, without its ends.
  Along on(Side side) {
    const Vec3 start = cornerAt(triangles_, startOf(triangles_, side));
    const Vec3 offset = cornerAt(triangles_, endOf(triangles_, side)) - start;
    const double min = std::min(start[axis_], start[axis_] + offset[axis_]) - tolerance_;
    const double max = std::max(start[axis_], start[axis_] + offset[axis_]) + tolerance_;
    std::vector<std::pair<double, std::int32_t>> found;
    auto next = std::lower_bound(corners_.begin(), corners_.end(), min,
                                 [this](std::int32_t corner, double value) { return place(corner) < value; });
    for (; next != corners_.end() && place(*next) <= max && tests_ < kMaxCompared; ++next, ++tests_) {
      const Face& face = triangles_.faces[static_cast<std::size_t>(faceOf(side))];
      if (std::find(face.begin(), face.end(), *next) != face.end()) continue;
      const Vec3 from_start = cornerAt(triangles_, *next) - start;
      const double share = from_start.dot(offset) / offset.squaredNorm();
      if (share > 0.0 && share < 1.0 && (from_start - share * offset).norm() <= tolerance_)
        found.emplace_back(share, *next);
    }
    std::sort(found.begin(), found.end());
    Along along;
    for (const auto& [share, corner] : found) along.push_back(corner);
    return along;
  }
  bool isTooMuch() const { return tests_ >= kMaxCompared; }

 private:
  double place(std::int32_t corner) const { return cornerAt(triangles_, corner)[axis_]; }
  const Triangles& triangles_;
  double tolerance_;
  Eigen::Index axis_ = 0;
  std::vector<std::int32_t> corners_;
  std::int64_t tests_ = 0;
};

/// Divides a face from its third corner to one on its first side, and so on: no part is without area.
void divide(const Face& face, const std::array<Along, 3>& on, std::vector<Face>& parts) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (on[k].empty()) continue;
    const auto middle = on[k].begin() + static_cast<std::ptrdiff_t>(on[k].size() / 2);
    const std::int32_t a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3];
    divide({a, *middle, c}, {Along(on[k].begin(), middle), {}, on[(k + 2) % 3]}, parts);
    divide({*middle, b, c}, {Along(middle + 1, on[k].end()), on[(k + 1) % 3], {}}, parts);
    return;
  }
  parts.push_back(face);
}

}  // namespace

std::optional<std::int64_t> divideAtSeams(Triangles& triangles, Edges& edges, double tolerance,
                                          const TaskMonitor& monitor) {
  std::vector<Side> borders;
  for (std::size_t side = 0; side < edges.across.size(); ++side) {
    if (edges.across[side] == kBorder) borders.push_back(static_cast<Side>(side));
  }
  if (borders.empty()) return 0;
  BorderCorners corners(triangles, borders, tolerance);
  Triangles divided{triangles.p_MV, {}};
  Steps steps(monitor);
  std::size_t next = 0;
  for (std::size_t face = 0; face < triangles.faces.size(); ++face) {
    std::array<Along, 3> on;
    for (; next < borders.size() && faceOf(borders[next]) == static_cast<std::int32_t>(face); ++next)
      on[static_cast<std::size_t>(borders[next] % 3)] = corners.on(borders[next]);
    if (steps.isCancelled()) return {};
    divide(triangles.faces[face], on, divided.faces);
  }
  const auto added = static_cast<std::int64_t>(divided.faces.size() - triangles.faces.size());
  if (added == 0 || corners.isTooMuch()) return 0;
  std::optional<Edges> now = edgesOf(divided, monitor);
  if (!now) return {};
  if (now->crowded > edges.crowded || now->borders >= edges.borders) return 0;
  triangles = std::move(divided);
  edges = std::move(*now);
  return added;
}

}  // namespace underact::mesh_file
