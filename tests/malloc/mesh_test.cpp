#include "core/base/trig.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/malloc/counter.h"
#include "tests/support/tick_hand.h"

namespace underact::tick {
namespace {

/// A ball of triangles as a wall and as a surface held to, and a curve with a guide, all of them rough.
std::vector<Entry> meshesAndCurve() {
  target::MeshPlace ball;
  ball.surface = mesh::makeSurface(mesh_maker::bumpySphere(20000)).value();
  ball.scale_m = 1e-3;
  ball.lean = mesh::forceShadingOf(0.3);
  std::vector<Entry> entries(3, Entry{{}, control::P{Vec3::Constant(500.0)}});
  for (Entry& entry : entries) entry.constraint.friction = {0.4, 0.3};
  entries[0].constraint.goal = entries[1].constraint.goal = ball;
  entries[0].constraint.side = target::Side::Outside;
  const std::vector<Vec3> points{{0.04, 0, 0}, {0, 0.04, 0}, {-0.04, 0, 0.01}, {0, -0.04, 0}};
  entries[2].constraint.goal = target::CurvePath{curve::makeCurve(points, curve::CurveKind::Spline, true).value(),
                                                 Search::Hybrid, curve::Guidance{0.25, 0.05, 0.01}};
  return entries;
}

TEST(MeshTick, AllocatesNothingWhateverItMeets) {
  test::Hand hand(meshesAndCurve(), Combine::Sum);
  hand.at({0.0, 0.05, 0.0});
  int touched = 0;
  test::Watch watch;
  for (int tick = 0; tick < 3000; ++tick) {  // over the ball's top, in and out of it
    const double t = 1e-3 * tick;
    hand.at({0.02 * sinCos(2.1 * t).sin, 0.036 + 0.004 * sinCos(5.3 * t).sin, 0.02 * sinCos(1.7 * t).cos});
    touched += hand.report().held[0].status == target::Status::Unique ? 1 : 0;
  }
  EXPECT_EQ(watch.allocations(), 0);
  EXPECT_EQ(watch.locks(), 0);
  EXPECT_GT(touched, 300);
  EXPECT_LT(touched, 2700);
}

}  // namespace
}  // namespace underact::tick
