#include "core/mesh_file/parts.h"

#include <algorithm>
#include <cmath>

#include "core/mesh_file/steps.h"

namespace underact::mesh_file {
namespace {

// Whether a part is within another is decided by a ray through all faces of a part; at most this many tests.
constexpr double kMaxRayTests = 1e8;
constexpr std::size_t kMaxNested = 1000;

class Finding {
 public:
  Finding(const mesh::Triangles& triangles, const Edges& edges, const TaskMonitor& monitor)
      : triangles_(triangles), edges_(edges), steps_(monitor) {
    found_.part_of.assign(triangles.faces.size(), -1);
    found_.is_against.assign(triangles.faces.size(), 0);
  }

  std::optional<Parts> all() {
    for (std::size_t face = 0; face < triangles_.faces.size(); ++face) {
      if (found_.part_of[face] < 0 && !grow(static_cast<std::int32_t>(face))) return {};
    }
    findNested();
    for (Part& part : found_.parts) {
      part.is_turned_over = isClosed(part) && !part.is_nested ? part.volume < 0.0 : 2 * part.against > part.faces;
      found_.clashes += part.clashes;
    }
    if (steps_.isCancelled()) return {};
    return std::move(found_);
  }

 private:
  /// Grows a new part from one face.
  bool grow(std::int32_t seed) {
    Part& part = found_.parts.emplace_back();
    const auto number = static_cast<std::int32_t>(found_.parts.size() - 1);
    part.some_corner = triangles_.faces[static_cast<std::size_t>(seed)][0];
    origin_ = cornerAt(triangles_, part.some_corner);  // near the part, so that volumes do not cancel
    found_.part_of[static_cast<std::size_t>(seed)] = number;
    todo_.assign(1, seed);
    std::int64_t clashing_sides = 0;
    while (!todo_.empty()) {
      if (steps_.isCancelled()) return false;
      const std::int32_t face = todo_.back();
      todo_.pop_back();
      add(face, part);
      for (Side side = 3 * face; side < 3 * face + 3; ++side) {
        const Side other = edges_.across[static_cast<std::size_t>(side)];
        if (other < 0) {
          part.is_open = true;
          continue;
        }
        const auto beside = static_cast<std::size_t>(faceOf(other));
        const bool agree = startOf(triangles_, side) != startOf(triangles_, other);
        const auto against =
            static_cast<std::uint8_t>(found_.is_against[static_cast<std::size_t>(face)] ^ (agree ? 0U : 1U));
        if (found_.part_of[beside] < 0) {
          found_.part_of[beside] = number;
          found_.is_against[beside] = against;
          todo_.push_back(faceOf(other));
        } else if (found_.is_against[beside] != against) {
          ++clashing_sides;
        }
      }
    }
    part.clashes = clashing_sides / 2;
    return true;
  }

  void add(std::int32_t face, Part& part) {
    const mesh::Face& corners = triangles_.faces[static_cast<std::size_t>(face)];
    const Vec3 a = cornerAt(triangles_, corners[0]), b = cornerAt(triangles_, corners[1]),
               c = cornerAt(triangles_, corners[2]);
    const bool is_against = found_.is_against[static_cast<std::size_t>(face)] != 0;
    const double sixfold = (a - origin_).dot((b - origin_).cross(c - origin_));
    part.volume += (is_against ? -sixfold : sixfold) / 6.0;
    part.area += 0.5 * (b - a).cross(c - a).norm();
    part.low = part.low.cwiseMin(a).cwiseMin(b).cwiseMin(c);
    part.high = part.high.cwiseMax(a).cwiseMax(b).cwiseMax(c);
    ++part.faces;
    part.against += is_against ? 1 : 0;
  }

  void findNested() {
    std::vector<std::size_t> closed;
    for (std::size_t k = 0; k < found_.parts.size(); ++k) {
      if (isClosed(found_.parts[k])) closed.push_back(k);
    }
    if (closed.size() > kMaxNested) closed.resize(kMaxNested);
    double tests = 0.0;
    for (const std::size_t inner : closed) {
      int around = 0;
      for (const std::size_t outer : closed) {
        const Part& in = found_.parts[inner];
        const Part& out = found_.parts[outer];
        if (inner == outer || !((in.low - out.low).minCoeff() >= 0.0 && (out.high - in.high).minCoeff() >= 0.0))
          continue;
        tests += static_cast<double>(triangles_.faces.size());
        // Beyond the bound it stays as in the file.
        if (tests > kMaxRayTests || isWithin(in.some_corner, static_cast<std::int32_t>(outer))) ++around;
        if (steps_.isCancelled()) return;
      }
      found_.parts[inner].is_nested = around > 0;
    }
  }

  /// Whether the ray from a corner, in a direction that no edge of ordinary meshes has, crosses the part an odd number
  /// of times.
  bool isWithin(std::int32_t corner, std::int32_t part) {
    const Vec3 from = cornerAt(triangles_, corner), along(0.5773, 0.2113, 0.7887);
    bool is_within = false;
    for (std::size_t face = 0; face < triangles_.faces.size(); ++face) {
      if (found_.part_of[face] != part) continue;
      if (steps_.isCancelled()) return false;
      const mesh::Face& corners = triangles_.faces[face];
      const Vec3 a = cornerAt(triangles_, corners[0]) - from, b = cornerAt(triangles_, corners[1]) - from,
                 c = cornerAt(triangles_, corners[2]) - from;
      const double u = along.dot(a.cross(b)), v = along.dot(b.cross(c)), w = along.dot(c.cross(a));
      const bool hits = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
      // Ahead, where the plane's distance along the ray is above 0.
      const Vec3 normal = (b - a).cross(c - a);
      if (hits && normal.dot(a) * normal.dot(along) > 0.0) is_within = !is_within;
    }
    return is_within;
  }

  const mesh::Triangles& triangles_;
  const Edges& edges_;
  Steps steps_;
  Parts found_;
  Vec3 origin_ = Vec3::Zero();
  std::vector<std::int32_t> todo_;
};

}  // namespace

std::optional<Parts> partsOf(const mesh::Triangles& triangles, const Edges& edges, const TaskMonitor& monitor) {
  return Finding(triangles, edges, monitor).all();
}

}  // namespace underact::mesh_file
