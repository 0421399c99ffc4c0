#include "tests/support/mesh_points.h"

#include <algorithm>
#include <cmath>

#include "tests/support/mesh_walker.h"

namespace underact::test {
namespace {

constexpr double kWholeTurn_rad = 6.283185307179586;

Eigen::AlignedBox3d boxOf(const mesh::Triangles& triangles) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p_MV : triangles.p_MV) box.extend(p_MV.cast<double>());
  return box;
}

/// A random point of a face.
Vec3 pointOn(const mesh::Triangles& triangles, std::size_t face, Random& random) {
  double u = random.between(0.0, 1.0), v = random.between(0.0, 1.0);
  if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
  const auto at = [&](std::size_t i) -> Vec3 {
    return triangles.p_MV[static_cast<std::size_t>(triangles.faces[face][i])].cast<double>();
  };
  return (1.0 - u - v) * at(0) + u * at(1) + v * at(2);
}

// A hand's way is walked in steps of 0.05 mm and smoothed over 1.5 mm, which is what a hand makes of a sharp edge; and
// over 4 ms, since no hand turns at once.
constexpr double kStep_mm = 0.05;
constexpr int kSmoothSteps = 30;
constexpr int kSmooth_ms = 4;

/// The mean by a bell of that spread, cut at three times it: shorter by six spreads.
std::vector<Vec3> smoothed(const std::vector<Vec3>& rough, int spread) {
  std::vector<double> bell;
  double weight = 0.0;
  for (int k = -3 * spread; k <= 3 * spread; ++k)
    weight += bell.emplace_back(std::exp(-0.5 * k * k / (1.0 * spread * spread)));
  std::vector<Vec3> smooth;
  for (std::size_t i = 0; i + bell.size() <= rough.size(); ++i) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < bell.size(); ++k) sum += bell[k] * rough[i + k];
    smooth.emplace_back(sum / weight);
  }
  return smooth;
}

/// Points above the surface, step by step along a winding way on it.
std::vector<Vec3> stroke(const mesh::Triangles& triangles, double mm, std::size_t steps, Seed seed) {
  MeshWalker walker(triangles, seed);
  std::vector<Vec3> rough;
  for (std::size_t i = 0; i < steps; ++i) {
    const double travel_mm = kStep_mm * static_cast<double>(i);
    walker.go(kStep_mm * mm);
    walker.turn(kStep_mm * 0.05 * std::sin(kWholeTurn_rad * travel_mm / 70.0));
    rough.push_back(walker.p_M() + mm * (1.5 + 3.5 * std::sin(kWholeTurn_rad * travel_mm / 37.0)) * walker.normal_M());
  }
  return smoothed(rough, kSmoothSteps);
}

/// Where one is on a way after a length, there and back again.
class Traveller {
 public:
  explicit Traveller(const std::vector<Vec3>& hand_path) : hand_path_(hand_path) {
    for (std::size_t i = 1; i < hand_path.size(); ++i)
      after_.push_back(after_.back() + (hand_path[i] - hand_path[i - 1]).norm());
  }
  Vec3 after(double length) const {
    const double whole = after_.back();
    if (!(whole > 0.0)) return hand_path_.front();
    const double in_turn = std::fmod(length, 2.0 * whole), at = in_turn < whole ? in_turn : 2.0 * whole - in_turn;
    const auto next = std::upper_bound(after_.begin() + 1, after_.end() - 1, at);
    const auto i = static_cast<std::size_t>(next - after_.begin());
    const double piece = after_[i] - after_[i - 1];
    const double share = piece > 0.0 ? std::clamp((at - after_[i - 1]) / piece, 0.0, 1.0) : 0.0;
    return hand_path_[i - 1] + share * (hand_path_[i] - hand_path_[i - 1]);
  }

 private:
  const std::vector<Vec3>& hand_path_;
  std::vector<double> after_{0.0};
};

}  // namespace

double diagonalOf(const mesh::Triangles& triangles) {
  return boxOf(triangles).diagonal().norm();
}

std::vector<Vec3> pointsNear(const mesh::Triangles& triangles, double reach, int count, Seed seed) {
  std::vector<double> up_to;  // of each face: the area of it and those before
  double sum = 0.0;
  for (const mesh::Face& face : triangles.faces) {
    const auto at = [&](std::size_t i) -> Vec3 {
      return triangles.p_MV[static_cast<std::size_t>(face[i])].cast<double>();
    };
    up_to.push_back(sum += (at(1) - at(0)).cross(at(2) - at(0)).norm());
  }
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const auto found = std::upper_bound(up_to.begin(), up_to.end(), random.between(0.0, sum));
    const std::size_t face = sum > 0.0 && found != up_to.end() ? static_cast<std::size_t>(found - up_to.begin())
                                                               : random.below(triangles.faces.size());
    const Vec3 p_M = pointOn(triangles, face, random);
    points.emplace_back(p_M + random.between(0.0, reach) * random.direction());
  }
  return points;
}

std::vector<Vec3> pointsAbout(const mesh::Triangles& triangles, int count, Seed seed) {
  const Eigen::AlignedBox3d box = boxOf(triangles);
  const double min = 0.1 * box.diagonal().norm();  // a flat mesh has a box without height
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(box.center() + random.inBox(0.75).cwiseProduct(box.sizes().cwiseMax(min)));
  }
  return points;
}

std::vector<Vec3> handPath(const mesh::Triangles& triangles, double mm, int milliseconds, Seed seed) {
  // Half as far again as the hand will go: rising and sinking, and corners, are cut short by the smoothing.
  const auto steps = static_cast<std::size_t>(1.5 * 0.3 * milliseconds / kStep_mm) + 2000U;
  const std::vector<Vec3> hand_path = stroke(triangles, mm, steps, seed);
  const Traveller traveller(hand_path);
  std::vector<Vec3> path;
  double gone = 0.0;
  for (int ms = 0; ms < milliseconds + 6 * kSmooth_ms; ++ms) {
    path.push_back(traveller.after(gone));
    gone += mm * (0.3 + 0.2 * std::sin(kWholeTurn_rad * ms / 1700.0));  // 0.1 to 0.5 m/s is as many mm/ms
  }
  return smoothed(path, kSmooth_ms);
}

}  // namespace underact::test
