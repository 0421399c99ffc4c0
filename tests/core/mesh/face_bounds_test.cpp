#include "core/mesh/face_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/mesh_oracle.h"
#include "tests/support/property.h"
#include "tests/support/random.h"

// Bounds of four faces' distances in floats against the oracle in long doubles.
namespace underact::mesh {
namespace {

using test::Random;
using test::Seed;

/// Faces without neighbours or tree: bounds look at neither.
Surface looseFaces(const std::vector<Vec3>& corners) {
  Surface surface;
  for (const Vec3& corner : corners) {
    const auto index = static_cast<std::int32_t>(surface.triangles.p_MV.size());
    surface.triangles.p_MV.push_back(corner.cast<float>());
    if (index % 3 == 2) surface.triangles.faces.push_back({index - 2, index - 1, index});
  }
  return surface;
}

struct Bounded {
  double bound, squared, longest_squared;
};

/// Each face's bound beside what is right.
std::array<Bounded, kAtOnce> bounded(const Surface& surface, const Vec3& q_M) {
  const std::array<float, kAtOnce> bounds = faceBounds(surface, {0, 1, 2, 3}, q_M);
  std::array<Bounded, kAtOnce> all{};
  for (std::size_t k = 0; k < kAtOnce; ++k) {
    const auto [a, b, c] = cornersOf(surface, static_cast<std::int32_t>(k));
    const test::MeshOracle alone({{a.cast<float>(), b.cast<float>(), c.cast<float>()}, {{0, 1, 2}}});
    const double distance = alone.distance(q_M);
    all[k] = {static_cast<double>(bounds[k]), distance * distance,
              std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()})};
  }
  return all;
}

double powerOfTen(Random& random, double low, double high) {
  return std::pow(10.0, random.between(low, high));
}

/// Four faces about a place, with edges from long to very short, and with sharp angles.
std::vector<Vec3> fourFaces(const Vec3& middle, double size, Random& random) {
  std::vector<Vec3> corners;
  for (std::size_t k = 0; k < kAtOnce; ++k) {
    const Vec3 a = middle + size * random.inBox(1.0);
    const Vec3 along = size * powerOfTen(random, -3.0, 0.0) * random.direction();
    corners.insert(corners.end(),
                   {a, a + along,
                    a + random.between(0.0, 1.0) * along + size * powerOfTen(random, -6.0, 0.0) * random.direction()});
  }
  return corners;
}

TEST(FaceBounds, AreNeverAboveTheDistanceWhateverTheFacesAre) {
  Random random(Seed{20070650});
  int given = 0;
  for (int i = 0; i < test::sweep(20000, 1000000); ++i) {
    const double size = powerOfTen(random, -12.0, 12.0);
    const Vec3 middle = size * powerOfTen(random, -2.0, 4.0) * random.direction();
    const Surface surface = looseFaces(fourFaces(middle, size, random));
    const Vec3 q_M = middle + size * powerOfTen(random, -8.0, 5.0) * random.direction();
    for (const Bounded& one : bounded(surface, q_M)) {
      // Of the oracle's own distance: a root in doubles, squared again.
      ASSERT_LE(one.bound, std::max(0.0, one.squared * (1.0 + 1e-14))) << "draw " << i;
      given += one.bound > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(given, test::sweep(20000, 1000000));  // a quarter of them, or the bound is never put to the test
}

TEST(FaceBounds, AreCloseWhereNoAngleIsSharp) {  // or a search would look at all faces exactly
  Random random(Seed{20070651});
  for (int i = 0; i < test::sweep(20000, 1000000); ++i) {
    std::vector<Vec3> corners;
    for (std::size_t k = 0; k < kAtOnce; ++k) {
      const Vec3 a = random.inBox(10.0), u = random.direction(), v = u.cross(random.direction()).normalized();
      corners.insert(corners.end(), {a, a + u, a + random.between(0.0, 1.0) * u + random.between(0.3, 1.0) * v});
    }
    const Vec3 q_M = corners[0] + random.between(0.0, 10.0) * random.direction();
    for (const Bounded& one : bounded(looseFaces(corners), q_M))
      ASSERT_GE(one.bound, (1.0 - 0x1p-13) * one.squared - 0x1p-14 * one.longest_squared) << "draw " << i;
  }
}

TEST(FaceBounds, SayNothingOfFacesWithoutAnAngleOrBeyondFloats) {
  const Vec3 q_M(0.0, 0.0, 1.0);
  const Vec3 a(3.0, 0.0, 0.0), b(4.0, 0.0, 0.0);
  const Surface surface = looseFaces({a, b, b,                                      // an edge
                                      a, a, a,                                      // a point
                                      a, b, Vec3(4.0, 0.1, 0.0),                    // sharp: 5.7 degrees
                                      1e15 * a, 1e15 * b, Vec3(3e15, 1e15, 0.0)});  // squares of areas: 1e60
  for (const float bound : faceBounds(surface, {0, 1, 2, 3}, q_M)) EXPECT_LE(bound, 0.0F);
}

TEST(FaceBounds, OfOneFaceAreTheSameInEachPlace) {
  const Surface surface = looseFaces({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  const std::array<float, kAtOnce> bounds = faceBounds(surface, {0, 0, 0, 0}, {0.25, 0.25, 2.0});
  for (const float bound : bounds) {
    EXPECT_EQ(bound, bounds[0]);
    EXPECT_NEAR(bound, 4.0, 4.0 * 0x1p-13 + 2.0 * 0x1p-14);
  }
}

}  // namespace
}  // namespace underact::mesh
