#include "core/mesh/force_shading.h"

#include "core/base/trig.h"
#include "core/base/units.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/support/mesh_points.h"
#include "tests/support/odd_meshes.h"
#include "tests/support/property.h"

namespace underact::mesh {
namespace {

using Shared = std::shared_ptr<const Surface>;

constexpr double kLean_deg = 20.0;

double angle_deg(const Vec3& a, const Vec3& b) {
  return atan2Of(a.cross(b).norm(), a.dot(b)) / kRadPerDegree;
}

/// Of 30 mm: a cube's faces drawn onto it.
Triangles ball(int faces) {
  Triangles triangles = mesh_maker::cube(faces);
  for (Eigen::Vector3f& corner : triangles.p_MV) corner *= 30.0F / corner.norm();
  return triangles;
}

/// Upright, about z, of that many sides: bends of 360 degrees / sides, and rims of a right angle.
Triangles prism(int sides) {
  Triangles triangles;
  for (int k = 0; k < sides; ++k) {
    const SinCos at = sinCos(2.0 * kPi * k / sides);
    for (const double z : {-20.0, 20.0}) triangles.p_MV.push_back(Vec3(20.0 * at.cos, 20.0 * at.sin, z).cast<float>());
  }
  triangles.p_MV.emplace_back(0.0F, 0.0F, -20.0F);
  triangles.p_MV.emplace_back(0.0F, 0.0F, 20.0F);
  for (int k = 0; k < sides; ++k) {
    const int low = 2 * k, next = 2 * ((k + 1) % sides);
    triangles.faces.push_back({low, next, next + 1});
    triangles.faces.push_back({low, next + 1, low + 1});
    triangles.faces.push_back({2 * sides, next, low});
    triangles.faces.push_back({2 * sides + 1, low + 1, next + 1});
  }
  return triangles;
}

/// Upright, its apex at the top, of that many sides that slope so.
Triangles cone(int sides, double slope_deg) {
  Triangles triangles;
  const SinCos slope = sinCos(kRadPerDegree * slope_deg);
  const double height = 20.0 * slope.sin / slope.cos;
  triangles.p_MV.emplace_back(0.0F, 0.0F, static_cast<float>(height));
  triangles.p_MV.emplace_back(0.0F, 0.0F, 0.0F);
  for (int k = 0; k < sides; ++k) {
    const SinCos at = sinCos(2.0 * kPi * k / sides);
    triangles.p_MV.push_back(Vec3(20.0 * at.cos, 20.0 * at.sin, 0.0).cast<float>());
    triangles.faces.push_back({0, 2 + k, 2 + (k + 1) % sides});
    triangles.faces.push_back({1, 2 + (k + 1) % sides, 2 + k});
  }
  return triangles;
}

/// The true direction and the smooth one at the point nearest to q.
struct Directions {
  Vec3 true_M, smooth_M, p_M;
};
Directions directionsAt(const Surface& surface, const Vec3& q_M, double max_deg = kLean_deg) {
  SearchState state;
  const Hit hit = nearestPoint(surface, Search::Global, q_M, state);
  const Vec3 u_M = (q_M - hit.p_M).normalized();
  return {u_M, shadedDirection(surface, hit, u_M, forceShadingOf(kRadPerDegree * max_deg)), hit.p_M};
}

TEST(ForceShading, OfABallOfFacesIsTheBall) {
  // Faces of h across are off from the sphere's normal by h / 2r; what corners give is off by its square.
  const Shared surface = makeSurface(ball(1200)).value();
  const double bend_deg = 60.0 / std::sqrt(200.0) / 30.0 / kRadPerDegree;  // of the largest squares, in the middle
  double worst_true = 0.0, worst_smooth = 0.0;
  for (const Vec3& q_M : test::pointsNear(ball(1200), 2.0, 5000, test::Seed{3})) {
    if (q_M.norm() < 30.1) continue;
    const Directions at = directionsAt(*surface, q_M);
    worst_true = std::max(worst_true, angle_deg(at.true_M, q_M));
    worst_smooth = std::max(worst_smooth, angle_deg(at.smooth_M, q_M));
  }
  EXPECT_GT(worst_true, 0.3 * bend_deg);
  EXPECT_LT(worst_smooth, 0.2 * worst_true);
}

TEST(ForceShading, IsNeverMoreThanItsLimitAndTheOtherWayRoundOnTheOtherSide) {
  for (const test::OddMesh& odd : test::oddMeshes()) {
    const auto made = makeSurface(odd.triangles);
    if (!made) continue;
    const Surface& surface = *made.value();
    for (const Vec3& q_M : test::pointsAbout(odd.triangles, 300, test::Seed{4})) {
      SearchState state;
      const Hit hit = nearestPoint(surface, Search::Global, q_M, state);
      const Vec3 u_M = (q_M - hit.p_M).stableNormalized();
      if (!(u_M.norm() > 0.5)) continue;
      for (const double max_deg : {5.0, 20.0, 45.0}) {
        const ForceShading max = forceShadingOf(kRadPerDegree * max_deg);
        const Vec3 there = shadedDirection(surface, hit, u_M, max);
        ASSERT_NEAR(there.norm(), 1.0, 1e-12) << odd.name;
        ASSERT_LE(angle_deg(there, u_M), max_deg + 1e-6) << odd.name;
        ASSERT_NEAR((shadedDirection(surface, hit, -u_M, max) + there).norm(), 0.0, 1e-12) << odd.name;
      }
      ASSERT_EQ(shadedDirection(surface, hit, u_M, {}), u_M) << odd.name;
    }
  }
}

TEST(ForceShading, SharpEdgesStayAsTheyAre) {
  const Shared surface = makeSurface(mesh_maker::cube(1200)).value();
  int on_edges = 0;
  for (const Vec3& q_M : test::pointsAbout(mesh_maker::cube(1200), 2000, test::Seed{5})) {
    const Directions at = directionsAt(*surface, q_M);
    on_edges += at.true_M.maxCoeff() < 0.99 ? 1 : 0;
    ASSERT_LT(angle_deg(at.smooth_M, at.true_M), 1e-4) << q_M.transpose();  // corners' normals are floats
  }
  EXPECT_GT(on_edges, 100);
}

TEST(ForceShading, OfAPrismTheSidesAreRoundAndTheRimsSharp) {
  const Shared surface = makeSurface(prism(24)).value();  // bends of 15 degrees; all corners are on the rims
  double worst_deg = 0.0;
  for (double turn_deg = 0.0; turn_deg < 360.0; turn_deg += 0.7) {
    const SinCos at = sinCos(kRadPerDegree * turn_deg);
    const Vec3 out_M(at.cos, at.sin, 0.0);
    const Directions cap = directionsAt(*surface, 10.0 * out_M + Vec3(0, 0, 22));
    EXPECT_LT(angle_deg(cap.smooth_M, Vec3::UnitZ()), 1e-4) << turn_deg;
    for (const double z : {-19.0, 0.0, 7.0}) {
      const Directions side = directionsAt(*surface, 22.0 * out_M + Vec3(0, 0, z));
      // Two triangles a side: what one's corners give is the round one's along the seams, and nearly so between.
      worst_deg = std::max(worst_deg, angle_deg(side.smooth_M, out_M));
    }
  }
  EXPECT_LT(worst_deg, 1.0);  // of the 7.5 degrees that the faces themselves are off
}

/// The largest step of the smooth direction on the way from a to b, that no closer look takes away; 0 where the nearest
/// point itself has a step, over a hollow.
double jumpBetween(const Surface& surface, const Vec3& a_M, const Vec3& b_M) {
  constexpr int kSteps = 400;
  const auto at = [&](double share) { return directionsAt(surface, a_M + share * (b_M - a_M)).smooth_M; };
  double from = 0.0, largest = 0.0;
  Vec3 last = at(0.0);
  for (int step = 1; step <= kSteps; ++step) {
    const Vec3 here = at(static_cast<double>(step) / kSteps);
    if ((here - last).norm() > largest) {
      largest = (here - last).norm();
      from = static_cast<double>(step - 1) / kSteps;
    }
    last = here;
  }
  double to = from + 1.0 / kSteps;
  for (int halving = 0; halving < 30; ++halving) {
    const double middle = 0.5 * (from + to);
    const bool in_first = (at(middle) - at(from)).norm() > (at(to) - at(middle)).norm();
    (in_first ? to : from) = middle;
  }
  const Directions before = directionsAt(surface, a_M + from * (b_M - a_M)),
                   after = directionsAt(surface, a_M + to * (b_M - a_M));
  if ((after.p_M - before.p_M).norm() > 1e-6) return 0.0;
  return (after.smooth_M - before.smooth_M).norm();
}

TEST(ForceShading, OnTheTipOfAConeItDoesNotMatterFromWhereOneComes) {
  for (const int sides : {16, 32, 60, 128, 400}) {
    for (const double slope_deg : {20.0, 45.0, 85.0}) {
      const Shared surface = makeSurface(cone(sides, slope_deg)).value();
      std::int32_t apex = 0;  // corners are renumbered
      for (std::size_t k = 0; k < surface->triangles.p_MV.size(); ++k) {
        if (surface->triangles.p_MV[k].z() > surface->triangles.p_MV[static_cast<std::size_t>(apex)].z())
          apex = static_cast<std::int32_t>(k);
      }
      Hit hit;
      hit.p_M = surface->triangles.p_MV[static_cast<std::size_t>(apex)].cast<double>();
      const Vec3 u_M = Vec3(0.1, 0.05, 1.0).normalized();
      std::vector<Vec3> answers;
      for (std::size_t face = 0; face < surface->triangles.faces.size(); ++face) {
        const Face& corners = surface->triangles.faces[face];
        for (std::size_t place = 0; place < 3; ++place) {
          if (corners[place] != apex) continue;
          hit.face = static_cast<std::int32_t>(face);
          hit.part = static_cast<Part>(static_cast<std::size_t>(Part::CornerA) + place);
          answers.push_back(shadedDirection(*surface, hit, u_M, forceShadingOf(kRadPerDegree * kLean_deg)));
        }
      }
      ASSERT_EQ(answers.size(), static_cast<std::size_t>(sides));
      for (const Vec3& answer : answers) EXPECT_LT((answer - answers[0]).norm(), 1e-12) << sides << " " << slope_deg;
    }
  }
}

/// A collinear face on a seam, as triangulators leave them where a corner of one side meets the middle of another.
TEST(ForceShading, FacesWithoutAreaPartNothing) {
  Triangles triangles = prism(24);
  // The seam from corner 0 to corner 1 gets a corner in its middle, for one of its two faces alone.
  const auto middle = static_cast<std::int32_t>(triangles.p_MV.size());
  triangles.p_MV.push_back(0.5F * (triangles.p_MV[0] + triangles.p_MV[1]));
  Face& beside = triangles.faces[1];  // {0, 3, 1}
  ASSERT_EQ(beside, (Face{0, 3, 1}));
  beside = {0, 3, middle};
  triangles.faces.push_back({middle, 3, 1});
  triangles.faces.push_back({0, middle, 1});
  const Shared surface = makeSurface(triangles).value();
  ASSERT_TRUE(surface->is_closed);
  for (const double z : {-19.5, 19.5}) {  // beside the ends of the seam; in its middle only one side has a corner
    Vec3 last_M = Vec3::Zero();
    for (double turn_deg = -6.0; turn_deg < 6.0; turn_deg += 0.05) {
      const SinCos at = sinCos(kRadPerDegree * turn_deg);
      const Vec3 smooth_M = directionsAt(*surface, {22.0 * at.cos, 22.0 * at.sin, z}).smooth_M;
      if (last_M != Vec3::Zero()) {
        EXPECT_LT(angle_deg(smooth_M, last_M), 0.5) << turn_deg << " at " << z;
      }
      last_M = smooth_M;
    }
  }
}

TEST(ForceShading, HasNoStepOverFacesEdgesAndCorners) {
  int looked = 0;
  test::Random random(test::Seed{6});
  for (const Triangles& triangles : {ball(1200), mesh_maker::cube(300)}) {
    const Shared surface = makeSurface(triangles).value();
    const std::vector<Vec3> points = test::pointsNear(triangles, 1.0, 60, test::Seed{7});
    for (const Vec3& a_M : points) {
      const Vec3 b_M = 1.5 * a_M + 4.0 * random.direction();
      // 2^-30 of a 400th of the way of some 10 mm; a direction turns by at most as much as a point 1 um off a corner.
      const double jump = jumpBetween(*surface, 1.5 * a_M, b_M);
      EXPECT_LT(jump, 1e-4) << a_M.transpose() << " to " << b_M.transpose();
      looked += jump > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(looked, 60);  // of 120
}

TEST(ForceShading, HasNoStepOverTheTipOfACone) {
  test::Random random(test::Seed{8});
  for (const auto& [sides, slope_deg] : {std::pair{32, 40.0}, {60, 85.0}, {128, 45.0}}) {
    const Shared surface = makeSurface(cone(sides, slope_deg)).value();
    const double top = static_cast<double>(surface->high_M.z());
    const auto above = [&]() -> Vec3 { return Vec3(0, 0, top + 1.5) + random.inBox(1.4); };
    int looked = 0;
    for (int trial = 0; trial < 60; ++trial) {
      const Vec3 a_M = above(), b_M = above();
      const double jump = jumpBetween(*surface, a_M, b_M);
      EXPECT_LT(jump, 1e-4) << sides << " from " << a_M.transpose() << " to " << b_M.transpose();
      looked += jump > 0.0 ? 1 : 0;
    }
    EXPECT_GT(looked, 30);
  }
}

}  // namespace
}  // namespace underact::mesh
