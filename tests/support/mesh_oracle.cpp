#include "tests/support/mesh_oracle.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/support/random.h"

namespace underact::test {
namespace {

using Wide = Eigen::Matrix<long double, 3, 1>;

/// The foot of q on the line from a to b, where it is between them.
std::optional<Wide> footOnEdge(const Wide& a, const Wide& b, const Wide& q_M) {
  const Wide ab = b - a;
  const long double length2 = ab.squaredNorm(), along = ab.dot(q_M - a);
  if (!(along > 0.0L && along < length2)) return {};
  return a + along / length2 * ab;
}

/// The foot of q on the plane of abc, where it is inside.
std::optional<Wide> footOnPlane(const Wide& a, const Wide& b, const Wide& c, const Wide& q_M) {
  const Wide normal = (b - a).cross(c - a);
  const long double length2 = normal.squaredNorm();
  if (!(length2 > 0.0L)) return {};
  const Wide foot = q_M - normal.dot(q_M - a) / length2 * normal;
  const bool inside = normal.dot((b - a).cross(foot - a)) >= 0.0L && normal.dot((c - b).cross(foot - b)) >= 0.0L &&
                      normal.dot((a - c).cross(foot - c)) >= 0.0L;
  if (!inside) return {};
  return foot;
}

/// Whether the ray from q meets abc; nothing: too near an edge, or q too near the plane, to say.
std::optional<bool> isMet(const Wide& a, const Wide& b, const Wide& c, const Wide& q_M, const Wide& ray) {
  const Wide qa = a - q_M, qb = b - q_M, qc = c - q_M;
  const long double ab = ray.dot(qa.cross(qb)), bc = ray.dot(qb.cross(qc)), ca = ray.dot(qc.cross(qa));
  const long double min = 1e-15L * std::max({qa.squaredNorm(), qb.squaredNorm(), qc.squaredNorm()});
  const bool all_left = ab > min && bc > min && ca > min, all_right = ab < -min && bc < -min && ca < -min;
  if (all_left || all_right) {
    const Wide normal = (b - a).cross(c - a);
    const long double height = normal.dot(qa);
    if (std::abs(height) < 1e-15L * normal.norm() * qa.norm()) return {};
    return height / normal.dot(ray) > 0.0L;
  }
  const bool one_left = ab > min || bc > min || ca > min, one_right = ab < -min || bc < -min || ca < -min;
  if (one_left && one_right) return false;
  return {};
}

}  // namespace

MeshOracle::MeshOracle(const mesh::Triangles& triangles) {
  const mesh::Face* last = nullptr;
  for (const mesh::Face& face : triangles.faces) {
    if (last != nullptr && face == *last) continue;  // what is said twice is no nearer
    last = &face;
    const auto at = [&](std::size_t i) -> Wide {
      return triangles.p_MV[static_cast<std::size_t>(face[i % 3])].cast<long double>();
    };
    faces_.push_back({at(0), at(1), at(2)});
    std::size_t longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((at(i + 1) - at(i)).squaredNorm() > (at(longest + 1) - at(longest)).squaredNorm()) longest = i;
      largest_ = std::max(largest_, at(i).cast<double>().cwiseAbs().maxCoeff());
    }
    Capsule capsule{at(longest).cast<double>(), at(longest + 1).cast<double>(), 0.0};
    // The slack is for the rounding of the capsules' own distances.
    capsule.radius = capsule.distance(at(longest + 2).cast<double>()) + 1e-12 * largest_;
    capsules_.push_back(capsule);
  }
}

double MeshOracle::Capsule::distance(const Vec3& q_M) const {
  const Vec3 ab = p_MB - p_MA;
  const double length2 = ab.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp(ab.dot(q_M - p_MA) / length2, 0.0, 1.0) : 0.0;
  return (p_MA + share * ab - q_M).norm();
}

MeshOracle::Wide MeshOracle::nearestOf(const Corners& face, const Wide& q_M) {
  const auto& [a, b, c] = face;
  Wide best = a;
  for (const std::optional<Wide>& one : {std::optional<Wide>(b), std::optional<Wide>(c), footOnEdge(a, b, q_M),
                                         footOnEdge(b, c, q_M), footOnEdge(c, a, q_M), footOnPlane(a, b, c, q_M)}) {
    if (one && (*one - q_M).squaredNorm() < (best - q_M).squaredNorm()) best = *one;
  }
  return best;
}

MeshOracle::Nearest MeshOracle::nearest(const Vec3& q_M) const {
  std::vector<double> off(faces_.size());
  double within = kInfinity;  // some face is at least so near
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    off[i] = capsules_[i].distance(q_M);
    within = std::min(within, off[i] + capsules_[i].radius);
  }
  const Wide asked = q_M.cast<long double>();
  Wide best = Wide::Constant(INFINITY);
  long double min = INFINITY;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (off[i] > within * (1.0 + 1e-9) + capsules_[i].radius) continue;
    const Wide p_M = nearestOf(faces_[i], asked);
    const long double distance = (p_M - asked).norm();
    if (!(distance < min)) continue;
    min = distance;
    best = p_M;
    within = std::min(within, static_cast<double>(min));
  }
  return {static_cast<double>(min), best.cast<double>()};
}

bool MeshOracle::isInside(const Vec3& q_M) const {
  Random random(Seed{20070609});
  for (;;) {
    const Vec3 ray = random.direction();
    bool inside = false, tells = true;
    for (std::size_t i = 0; tells && i < faces_.size(); ++i) {
      const Capsule& about = capsules_[i];
      const double reach = 0.5 * (about.p_MB - about.p_MA).norm() + about.radius;
      if (ray.cross(0.5 * (about.p_MA + about.p_MB) - q_M).norm() > reach * (1.0 + 1e-9)) continue;
      const std::optional<bool> met =
          isMet(faces_[i].a, faces_[i].b, faces_[i].c, q_M.cast<long double>(), ray.cast<long double>());
      tells = met.has_value();
      if (met.value_or(false)) inside = !inside;
    }
    if (tells) return inside;
  }
}

}  // namespace underact::test
