#include "core/mesh/proxy.h"

#include "core/base/trig.h"
#include "core/base/units.h"
#include "core/mesh/crossing.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/support/mesh_oracle.h"
#include "tests/support/mesh_points.h"
#include "tests/support/odd_meshes.h"
#include "tests/support/property.h"

namespace underact::mesh {
namespace {

std::shared_ptr<const Surface> surfaceOf(Triangles triangles) {
  return makeSurface(std::move(triangles)).value();
}

/// A tip that goes from a to b in equal steps; look(hit, q) at each.
template <class Look>
void go(const Surface& surface, ProxyState& state, const Vec3& a, const Vec3& b, int steps, const Look& look) {
  for (int step = 1; step <= steps; ++step) {
    const Vec3 q = a + (b - a) * (static_cast<double>(step) / steps);
    look(followProxy(surface, FreeSide::Outside, q, state), q);
  }
}

TEST(Touch, FiveMetresASecondIntoAPlateOfAMillimetreStayOnItsFront) {
  // 5 mm a tick: a tick in front of the plate, the next one four plates behind it. Fine and coarse.
  for (const int faces : {12, 2000, 20000}) {
    const std::shared_ptr<const Surface> plate = surfaceOf(mesh_maker::plate(1.0, faces));
    const double front = static_cast<double>(plate->high_M.z());
    for (double x = -20.0; x <= 20.0; x += 1.7) {
      for (double start = 0.1; start < 5.0; start += 0.6) {
        ProxyState state;
        ASSERT_EQ(followProxy(*plate, FreeSide::Outside, {x, 3.1, front + start + 5.0}, state).face, -1);
        ASSERT_EQ(followProxy(*plate, FreeSide::Outside, {x, 3.1, front + start}, state).face, -1);
        for (double z = front + start - 5.0; z > front - 30.0; z -= 5.0) {
          const Hit hit = followProxy(*plate, FreeSide::Outside, {x, 3.1, z}, state);
          ASSERT_GE(hit.face, 0) << "x " << x << " z " << z;
          ASSERT_NEAR((hit.p_M - Vec3(x, 3.1, front)).norm(), 0.0, 1e-12);
        }
        ASSERT_EQ(followProxy(*plate, FreeSide::Outside, {x, 3.1, front + 0.01}, state).face, -1);  // and back out
      }
    }
  }
}

TEST(Touch, NeitherDepthNorScaleNorFinenessOpensAPlate) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    Triangles triangles = mesh_maker::plate(1.0, 500);
    for (Eigen::Vector3f& corner : triangles.p_MV) corner *= static_cast<float>(scale);
    const std::shared_ptr<const Surface> plate = surfaceOf(std::move(triangles));
    const double front = static_cast<double>(plate->high_M.z());
    ProxyState state;
    followProxy(*plate, FreeSide::Outside, Vec3(1, 2, 0) * scale + Vec3(0, 0, front + scale), state);
    for (const double depth : {1e-9, 1e-6, 1e-3, 0.5, 3.0, 100.0}) {
      const Hit hit =
          followProxy(*plate, FreeSide::Outside, Vec3(1, 2, 0) * scale + Vec3(0, 0, front - depth * scale), state);
      ASSERT_GE(hit.face, 0) << "scale " << scale << " depth " << depth;
      EXPECT_NEAR(hit.p_M.z(), front, 1e-12 * scale);
    }
  }
}

TEST(Touch, AtASharpEdgeTheProxyStaysUntilTheTipIsPastIt) {
  const std::shared_ptr<const Surface> cube = surfaceOf(mesh_maker::cube(1200));
  ProxyState state;
  const auto nothing = [](const Hit&, const Vec3&) {};
  go(*cube, state, {20, 0, 40}, {20, 0, 27}, 20, nothing);  // into the top, 3 mm deep, 10 mm from its edge
  go(*cube, state, {20, 0, 27}, {29.5, 0, 27}, 40, [](const Hit& hit, const Vec3& q) {
    ASSERT_GE(hit.face, 0);
    // The side is nearer from 27 mm on, but the way over the edge goes up: the proxy stays on the top.
    EXPECT_NEAR(hit.p_M.z(), 30.0, 1e-12) << q.transpose();
    EXPECT_NEAR(hit.p_M.x(), q.x(), 1e-12);
  });
  go(*cube, state, {29.5, 0, 27}, {32, 0, 27}, 10, [](const Hit& hit, const Vec3& q) {
    EXPECT_EQ(hit.face >= 0, q.x() < 30.0) << q.transpose();  // out by the side: free
  });
}

TEST(Touch, InAConcaveEdgeTheProxyRestsInTheEdgeWithoutATremble) {
  const Triangles wedge = mesh_maker::wedge(4000);
  const std::shared_ptr<const Surface> surface = surfaceOf(wedge);
  const test::MeshOracle oracle(wedge);
  // The groove's bottom: straight down from above the middle, the deepest place that is still outside.
  double bottom = static_cast<double>(surface->high_M.z());
  while (!oracle.isInside({0.0, 1.3, bottom - 0.01})) bottom -= 0.01;
  ProxyState state;
  const auto nothing = [](const Hit&, const Vec3&) {};
  go(*surface, state, {0, 1.3, bottom + 8.0}, {0, 1.3, bottom - 2.0}, 50, nothing);
  Vec3 last(0, 1.3, 0);
  for (int tick = 0; tick < 2000; ++tick) {  // a tremble of 0.05 mm about the middle
    const double t = 0.02 * tick;
    const Vec3 q(0.05 * sinCos(37.0 * t).sin, 1.3 + 0.05 * sinCos(23.0 * t).sin, bottom - 2.0);
    const Hit hit = followProxy(*surface, FreeSide::Outside, q, state);
    ASSERT_GE(hit.face, 0);
    ASSERT_NEAR(hit.p_M.x(), 0.0, 1e-6) << tick;  // in the edge: the walls are 33 degrees from upright
    // No further than the tip went in the tick: 0.05 mm at 37 and 23 rad/s, 0.02 s apart.
    if (tick > 0) {
      ASSERT_LE((hit.p_M - last).norm(), 0.05 * 0.02 * (37.0 + 23.0) + 1e-9);
    }
    last = hit.p_M;
  }
}

TEST(Touch, AFirstTipIsBehindTheWallWhereTheNearestPointSaysSo) {
  const std::shared_ptr<const Surface> cube = surfaceOf(mesh_maker::cube(300));
  ProxyState inside, outside, room;
  EXPECT_NEAR(followProxy(*cube, FreeSide::Outside, {0, 0, 28}, inside).p_M.z(), 30.0, 1e-12);
  EXPECT_EQ(followProxy(*cube, FreeSide::Outside, {0, 0, 31}, outside).face, -1);
  EXPECT_NEAR(followProxy(*cube, FreeSide::Inside, {0, 0, 31}, room).p_M.z(), 30.0, 1e-12);
}

/// Along a hand's way over closed meshes: whether something is touched is what the oracle says of the tip, but where a
/// proxy holds on to the side that the tip came in by. So on a way that only ever goes in a little it is the same.
TEST(Touch, AgreesWithTheOracleAlongShallowStrokes) {
  for (const auto& make : {mesh_maker::bumpySphere, mesh_maker::torusKnot}) {
    const Triangles triangles = make(20000);
    const std::shared_ptr<const Surface> surface = surfaceOf(triangles);
    const test::MeshOracle oracle(triangles);
    ProxyState state;
    int touched = 0, tick = 0;
    for (const Vec3& q : test::handPath(triangles, 1.0, 3000, test::Seed{77})) {
      const Hit hit = followProxy(*surface, FreeSide::Outside, q, state);
      touched += hit.face >= 0 ? 1 : 0;
      if (tick++ % 10 != 0 || oracle.distance(q) < 1e-9) continue;
      EXPECT_EQ(hit.face >= 0, oracle.isInside(q)) << "tick " << tick << " at " << q.transpose();
    }
    EXPECT_GT(touched, 300);  // 2 mm inside to 5 mm outside
    EXPECT_LT(touched, 2700);
  }
}

TEST(Touch, AnyStateIsSafe) {
  const std::shared_ptr<const Surface> cube = surfaceOf(mesh_maker::cube(300));
  for (const std::int32_t face : {-7, 0, 299, 100000, INT32_MAX, INT32_MIN}) {
    for (const double lost : {0.0, kNotANumber, kInfinity, 1e300}) {
      ProxyState state{face, true, Vec3::Constant(lost)};
      const Hit hit = followProxy(*cube, FreeSide::Outside, {1, 2, 28}, state);
      EXPECT_TRUE(hit.p_M.allFinite());
      EXPECT_LT(hit.face, 1000);
    }
  }
}

}  // namespace
}  // namespace underact::mesh
