#include "tests/support/gap_meshes.h"

#include <array>
#include <cmath>
#include <map>

#include "core/base/units.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/support/random.h"

namespace underact::test {
namespace {

using mesh::Face;
using mesh::Triangles;
using Outline = std::vector<std::array<double, 2>>;  // x and y, counterclockwise

/// From z = -half to half; cap: the triangles of an end, whose corners are those of the outline and those after it.
Triangles prism(const Outline& outline, const std::vector<Face>& cap, std::size_t corners_in_wall, double half) {
  Triangles made;
  const auto count = static_cast<std::int32_t>(outline.size()), around = static_cast<std::int32_t>(corners_in_wall);
  for (const double z : {-half, half}) {
    for (const auto& [x, y] : outline) made.p_MV.push_back(Vec3(x, y, z).cast<float>());
  }
  for (const Face& face : cap) {
    made.faces.push_back({face[0], face[2], face[1]});
    made.faces.push_back({face[0] + count, face[1] + count, face[2] + count});
  }
  for (std::int32_t k = 0; k < around; ++k) {
    const std::int32_t next = (k + 1) % around;
    made.faces.push_back({k, next, next + count});
    made.faces.push_back({k, next + count, k + count});
  }
  return made;
}

/// A prism whose outline is seen as a whole from one point.
Triangles fanPrism(Outline outline, const std::array<double, 2>& middle, double half) {
  const std::size_t around = outline.size();
  std::vector<Face> cap;
  for (std::size_t k = 0; k < around; ++k) {
    cap.push_back(
        {static_cast<std::int32_t>(k), static_cast<std::int32_t>((k + 1) % around), static_cast<std::int32_t>(around)});
  }
  outline.push_back(middle);
  return prism(outline, cap, around, half);
}

GapMesh slot(double width_mm) {
  GapMesh made{"slot of " + std::to_string(width_mm) + " mm", slotBlock(width_mm), {}};
  for (double y = -20.0; y < 25.0; y += 5.0) {
    for (const double z : {20.0, 19.0, -20.0}) made.aims.emplace_back(0.0, y, z);
  }
  return made;
}

GapMesh groove(double width_mm) {
  const double half = 0.5 * width_mm;
  const Outline outline{{-25, -20}, {25, -20}, {25, 20}, {half, 20}, {0, -10}, {-half, 20}, {-25, 20}};
  GapMesh made{"groove of " + std::to_string(width_mm) + " mm", fanPrism(outline, {0, -15}, 25.0), {}};
  for (double y = -10.0; y <= 20.0; y += 2.0) {
    for (const double z : {-25.0, 0.0, 25.0}) made.aims.emplace_back(0.0, y, z);
  }
  return made;
}

GapMesh star(int rays, double inner_mm) {
  Outline outline;
  GapMesh made{"star of " + std::to_string(rays) + " rays", {}, {}};
  for (int k = 0; k < 2 * rays; ++k) {
    const double angle_rad = kPi * k / rays, radius_mm = k % 2 == 0 ? 25.0 : inner_mm;
    outline.push_back({radius_mm * std::cos(angle_rad), radius_mm * std::sin(angle_rad)});
    made.aims.emplace_back(outline.back()[0], outline.back()[1], k % 3 == 0 ? 15.0 : 0.0);
  }
  made.triangles = fanPrism(outline, {0, 0}, 15.0);
  return made;
}

/// A ball of 15 mm with a spike on each face.
GapMesh spikyBall(int faces, double height_mm) {
  constexpr double kRadius_mm = 15.0;
  GapMesh made{"ball of " + std::to_string(faces) + " spikes", mesh_maker::bumpySphere(faces), {}};
  for (Eigen::Vector3f& p_MV : made.triangles.p_MV) {
    p_MV = (kRadius_mm * p_MV.cast<double>().normalized()).cast<float>();
    made.aims.push_back(p_MV.cast<double>());
  }
  std::vector<Face> spikes;
  for (const auto& [a, b, c] : made.triangles.faces) {
    const Vec3 middle = cornerAt(made.triangles, a) + cornerAt(made.triangles, b) + cornerAt(made.triangles, c);
    const auto apex = static_cast<std::int32_t>(made.triangles.p_MV.size());
    made.triangles.p_MV.push_back(((kRadius_mm + height_mm) * middle.normalized()).cast<float>());
    made.aims.push_back(cornerAt(made.triangles, apex));
    for (const Face& face : {Face{a, b, apex}, Face{b, c, apex}, Face{c, a, apex}}) spikes.push_back(face);
  }
  made.triangles.faces = std::move(spikes);
  return made;
}

/// A surface where a function of the points of a lattice is zero, by marching tetrahedra; the function is below 0
/// inside.
class Marching {
 public:
  template <class Function>
  Marching(int cells, double half, const Function& f) : cells_(cells) {
    for (int place = 0; place < (cells + 1) * (cells + 1) * (cells + 1); ++place) {
      const Vec3 at(place % (cells + 1), place / (cells + 1) % (cells + 1), place / ((cells + 1) * (cells + 1)));
      points_.emplace_back(2.0 * half / cells * at - Vec3::Constant(half));
      const double value = f(points_.back());
      // Away from 0, so that no triangle has less than a thousandth of a cell.
      values_.push_back(std::copysign(std::max(std::abs(value), 0.02), value));
    }
  }
  Triangles surface() {
    // Six tetrahedra about the diagonal of each cell.
    constexpr std::array<std::array<int, 2>, 6> kPaths{{{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}}};
    for (int z = 0; z < cells_; ++z) {
      for (int y = 0; y < cells_; ++y) {
        for (int x = 0; x < cells_; ++x) {
          const auto corner = [&](int bits) {
            return (x + bits % 2) + (cells_ + 1) * ((y + bits / 2 % 2) + (cells_ + 1) * (z + bits / 4));
          };
          for (const auto& [a, b] : kPaths) tetrahedron({corner(0), corner(a), corner(b), corner(7)});
        }
      }
    }
    return std::move(made_);
  }

 private:
  void tetrahedron(const std::array<int, 4>& corners) {
    std::vector<int> in, out;
    for (const int corner : corners) (valueAt(corner) < 0.0 ? in : out).push_back(corner);
    if (in.empty() || out.empty()) return;
    const Vec3 outwards = pointAt(out[0]) - pointAt(in[0]);
    if (in.size() == 2) {
      const std::array<std::int32_t, 4> ring{on(in[0], out[0]), on(in[0], out[1]), on(in[1], out[1]),
                                             on(in[1], out[0])};
      add({ring[0], ring[1], ring[2]}, outwards);
      add({ring[0], ring[2], ring[3]}, outwards);
      return;
    }
    const std::vector<int>& three = in.size() == 1 ? out : in;
    const int alone = in.size() == 1 ? in[0] : out[0];
    add({on(alone, three[0]), on(alone, three[1]), on(alone, three[2])}, outwards);
  }
  void add(Face face, const Vec3& outwards) {
    const auto at = [&](std::size_t k) { return cornerAt(made_, face[k]); };
    if ((at(1) - at(0)).cross(at(2) - at(0)).dot(outwards) < 0.0) std::swap(face[1], face[2]);
    made_.faces.push_back(face);
  }
  std::int32_t on(int a, int b) {
    const auto [found, is_new] = corners_.try_emplace(std::minmax(a, b), made_.p_MV.size());
    const auto [low, high] = found->first;
    if (is_new) {
      const double share = valueAt(low) / (valueAt(low) - valueAt(high));
      made_.p_MV.push_back((pointAt(low) + share * (pointAt(high) - pointAt(low))).cast<float>());
    }
    return static_cast<std::int32_t>(found->second);
  }
  double valueAt(int place) const { return values_[static_cast<std::size_t>(place)]; }
  const Vec3& pointAt(int place) const { return points_[static_cast<std::size_t>(place)]; }

  int cells_;
  std::vector<Vec3> points_;
  std::vector<double> values_;
  std::map<std::pair<int, int>, std::size_t> corners_;
  Triangles made_;
};

/// The part of a ball of 12 mm near a gyroid of 12 mm period; wall: below 1.5, where nothing is left of the gaps.
GapMesh gyroid(int cells, double wall) {
  GapMesh made{"gyroid of " + std::to_string(cells) + " cells", {}, {}};
  made.triangles = Marching(cells, 13.0, [wall](const Vec3& p) {
                     const Eigen::Array3d at = 2.0 * kPi / 12.0 * p.array();
                     const Eigen::Array3d sine = at.sin(), cosine = at.cos();
                     const double g = sine[0] * cosine[1] + sine[1] * cosine[2] + sine[2] * cosine[0];
                     return std::max(std::abs(g) - wall, 0.3 * (p.norm() - 12.0));
                   }).surface();
  for (const Eigen::Vector3f& p_MV : made.triangles.p_MV) made.aims.push_back(p_MV.cast<double>());
  return made;
}

}  // namespace

mesh::Triangles slotBlock(double width_mm) {
  const double half = 0.5 * width_mm;
  const Outline outline{{-25, -25}, {25, -25}, {25, 25}, {half, 25}, {half, -20}, {-half, -20}, {-half, 25}, {-25, 25}};
  return prism(outline, {{0, 5, 7}, {5, 6, 7}, {0, 4, 5}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}}, outline.size(), 20.0);
}

std::vector<GapMesh> gapMeshes() {
  std::vector<GapMesh> all;
  for (const double width_mm : {0.01, 0.03, 0.1, 0.2, 0.4, 1.0}) all.push_back(slot(width_mm));
  for (const double width_mm : {0.1, 0.5, 2.0, 10.0}) all.push_back(groove(width_mm));
  all.push_back(star(12, 8.0));
  all.push_back(star(60, 5.0));
  all.push_back(star(120, 20.0));
  all.push_back(spikyBall(80, 10.0));
  all.push_back(spikyBall(320, 15.0));
  all.push_back(gyroid(16, 0.4));
  all.push_back(gyroid(18, 1.3));
  const Mat3 slant = Eigen::AngleAxisd(1.0, Vec3(0.6, 0.0, 0.8)).toRotationMatrix();
  for (GapMesh& one : all) {
    for (Eigen::Vector3f& p_MV : one.triangles.p_MV) p_MV = (slant * p_MV.cast<double>()).cast<float>();
    for (Vec3& aim : one.aims) aim = slant * aim;
  }
  return all;
}

}  // namespace underact::test
