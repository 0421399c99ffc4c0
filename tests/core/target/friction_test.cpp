#include "core/target/friction.h"

#include <algorithm>
#include <cmath>

#include "core/target/constraint.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/support/property.h"

namespace underact::target {
namespace {

const Vec3 kEqual = Vec3::Ones();

Constraint rough(const shape::Shape& shape, Side side, const Friction& friction) {
  Constraint constraint = makeConstraint(shape, side, kEqual);
  constraint.friction = friction;
  return constraint;
}

/// One tick: the target with friction.
Target targetWithFriction(const Constraint& constraint, const Vec3& p_WT, State& state) {
  Details details;
  return targetOf(constraint, p_WT, Mat3::Identity(), 1e-3, state, details);
}

/// What it would be of a force with equal gains: across and along the plane z = 0.
double shareOf(const Target& target, const Vec3& p_WT) {
  const Vec3 e_W = target.p_WP - p_WT;
  return e_W.head<2>().norm() / e_W.z();
}

const shape::Plane kFloor = shape::makePlane(Vec3::Zero(), Vec3::UnitZ(), {}).value();

TEST(Friction, HoldsUpToTheStaticShareAndThenSlidesOnAtTheDynamicOne) {
  const Constraint floor = rough(kFloor, Side::Outside, {0.5, 0.3});
  State state;
  const double depth_m = 0.002;
  EXPECT_EQ(targetWithFriction(floor, {0, 0, -depth_m}, state).p_WP, Vec3::Zero());
  double x_m = 0.0;
  for (; x_m <= 0.5 * depth_m; x_m += 1e-5) {
    ASSERT_EQ(targetWithFriction(floor, {x_m, 0, -depth_m}, state).p_WP, Vec3::Zero()) << "sticks at " << x_m;
  }
  double last = 0.5;
  for (int tick = 0; tick < 1000; ++tick) {
    const double share = shareOf(targetWithFriction(floor, {x_m, 0, -depth_m}, state), {x_m, 0, -depth_m});
    // From one to the other within 20 ms, without a step: 0.2 of the depth in 20 ticks.
    ASSERT_NEAR(share, std::max(0.3, 0.5 - 0.01 * tick), 1e-9) << tick;
    ASSERT_LE(last - share, 0.01 + 1e-9);
    last = share;
    x_m += 1e-5;
  }
  const Vec3 held_W = state.grip.p_WG;
  const Vec3 back_W(x_m - 1e-4, 0, -depth_m);  // the hand turns round: the target stays where it is first
  EXPECT_EQ(targetWithFriction(floor, back_W, state).p_WP, held_W);
  EXPECT_EQ(state.grip.hold, Hold::Slides);
  for (int tick = 0; tick < 200; ++tick) targetWithFriction(floor, back_W, state);
  EXPECT_EQ(state.grip.hold, Hold::Sticks) << "it rests, so that the static share holds again";
}

TEST(Friction, SlidingBegunAnewAlsoHoldsInTheFilesOfOlderStates) {
  Grip old;
  old.hold = Hold::Sticks;
  old.unused = 255, old.relaxation_left_us = 65535, old.speed_m_per_s = NAN;  // what lay beside the flag
  EXPECT_TRUE(isValid(old));
  EXPECT_FALSE(slides({0.5, 0.3}, {0, 0, -0.001}, Vec3::Zero(), 1e-3, old));
  EXPECT_TRUE(slides({0.5, 0.3}, {0.001, 0, -0.001}, {0.001, 0, 0}, 1e-3, old));
  EXPECT_TRUE(isValid(old));
  EXPECT_GE(old.speed_m_per_s, 0.0F);
  for (const float spoiled : {NAN, INFINITY, -1.0F}) {
    old.speed_m_per_s = spoiled;
    EXPECT_FALSE(isValid(old)) << spoiled << " would go on in all ticks that follow";
  }
}

/// The mean lag over the mean depth, both along the path of a tip that goes 20 mm, 4 mm deep, in steps of an encoder.
double meanShareAt(double speed_m_per_s, const Constraint& constraint, double dt_s) {
  constexpr double kStep_m = 5.5e-5, kDepth_m = 0.004, kWay_m = 0.06;
  State state = makeState(constraint.goal);
  double lag_m = 0.0, depth_m = 0.0;
  for (double x_m = -0.5 * kWay_m; x_m < 0.5 * kWay_m; x_m += speed_m_per_s * dt_s) {
    const Vec3 p_WT(kStep_m * std::floor(x_m / kStep_m), 0.001, -kDepth_m);
    Details details;
    const Target target = targetOf(constraint, p_WT, Mat3::Identity(), dt_s, state, details);
    if (x_m < 0.0) continue;  // it slips, and slides from then on
    lag_m += p_WT.x() - target.p_WP.x();
    depth_m += target.p_WP.z() - p_WT.z();
  }
  return lag_m / depth_m;
}

// 1 %: the steps of the encoder, 55 um, are 4 % of the lag of 1.2 mm; the mean is that of the law but for one step in
// its 500.
TEST(Friction, TheMeanIsTheDynamicShareFrom3To300MillimetresPerSecond) {
  MeshPlace place;
  place.surface = mesh::makeSurface(mesh_maker::cube(3000)).value();  // 60 mm
  place.scale_m = 2e-3;
  place.p_WM = {0, 0, -0.06};
  Constraint mesh;
  mesh.goal = place;
  mesh.side = Side::Outside;
  mesh.friction = {0.5, 0.3};
  const std::vector<Constraint> flat{
      rough(kFloor, Side::Outside, mesh.friction), mesh,
      rough(shape::makeBox({0, 0, -0.06}, Vec3::Constant(0.12), Mat3::Identity(), {}).value(), Side::Outside,
            mesh.friction)};
  for (const double speed_mm_per_s : {3.0, 10.0, 30.0, 100.0, 300.0}) {
    for (const double rate_hz : {1000.0, 4000.0}) {
      for (std::size_t index = 0; index < flat.size(); ++index) {
        EXPECT_NEAR(meanShareAt(1e-3 * speed_mm_per_s, flat[index], 1.0 / rate_hz), 0.3, 0.003)
            << speed_mm_per_s << " mm/s, " << rate_hz << " Hz, constraint " << index;
      }
    }
  }
}

TEST(Friction, WithEqualSharesTheDragIsSteady) {
  const Constraint floor = rough(kFloor, Side::Outside, {0.4, 0.4});
  State state;
  targetWithFriction(floor, {0, 0, -0.001}, state);
  for (double x_m = 1e-3; x_m < 0.05; x_m += 1e-4) {
    ASSERT_NEAR(shareOf(targetWithFriction(floor, {x_m, 0, -0.001}, state), {x_m, 0, -0.001}), 0.4, 1e-9);
  }
}

TEST(Friction, LeavingTheWallForgetsTheGrip) {
  const Constraint floor = rough(kFloor, Side::Outside, {1.0, 1.0});
  State state;
  targetWithFriction(floor, {0, 0, -0.001}, state);
  EXPECT_EQ(targetWithFriction(floor, {0.01, 0, 0.001}, state).status, Status::Free);
  EXPECT_EQ(state.grip.hold, Hold::None);
  EXPECT_EQ(targetWithFriction(floor, {0.02, 0, -0.001}, state).p_WP, Vec3(0.02, 0, 0));
}

TEST(Friction, OnEveryShapeTheTargetStaysOnTheShapeAndInTheCone) {
  const Friction friction{0.6, 0.45};
  const std::vector<shape::Shape> shapes{kFloor,
                                         shape::makeSphere({0, 0, 0}, 0.04, {}).value(),
                                         shape::makeCylinder({0, 0, 0}, {1, 2, 3}, 0.03, {}).value(),
                                         shape::makeCircle({0, 0, 0}, {0, 0, 1}, 0.05, {}).value(),
                                         shape::makeLine({0, 0, 0}, {1, 1, 0}, {}).value(),
                                         shape::makeBox({0, 0, 0}, {0.08, 0.06, 0.1}, Mat3::Identity(), {}).value()};
  test::Random random{test::Seed{21}};
  for (const shape::Shape& shape : shapes) {
    const Constraint constraint = rough(shape, Side::Both, friction);
    State state;
    Vec3 p_WT = Vec3(0.03, 0.03, 0.05), v_W = Vec3::Zero();
    for (int tick = 0; tick < 4000; ++tick) {
      v_W = 0.98 * v_W + 2e-5 * random.direction();
      p_WT += v_W - 1e-3 * (p_WT.norm() > 0.07 ? p_WT : Vec3(Vec3::Zero()));
      const Target smooth = targetWithFriction(rough(shape, Side::Both, {}), p_WT, state);
      const Target target = targetWithFriction(constraint, p_WT, state);
      if (target.status != Status::Unique) continue;
      // On the shape: the nearest of itself. Along it by no more than the static share of the depth.
      ASSERT_NEAR((closestPoint(shape, target.p_WP).p_WP - target.p_WP).norm(), 0.0, 1e-12);
      // What is put back onto a bend lies a little farther along it.
      ASSERT_LE((target.p_WP - smooth.p_WP).norm(), 0.6 * smooth.distance_m * (1 + 1e-3) + 1e-6) << "tick " << tick;
    }
  }
}

TEST(Friction, OnAMeshItIsThatOfTheShapeThatTheMeshIs) {
  MeshPlace place;
  place.surface = mesh::makeSurface(mesh_maker::cube(3000)).value();  // 60 mm
  place.scale_m = 1e-3;
  place.R_WM = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  place.p_WM = {0.01, 0.02, 0.03};
  Constraint mesh,
      box = rough(shape::makeBox(place.p_WM, Vec3::Constant(0.06), place.R_WM, {}).value(), Side::Outside, {0.5, 0.3});
  mesh.goal = place;
  mesh.side = Side::Outside;
  mesh.friction = {0.5, 0.3};
  State on_mesh = makeState(mesh.goal), on_box;
  for (int tick = 0; tick < 3000; ++tick) {  // over the top, 1 mm deep, from one side to the other
    const Vec3 q_M(-25.0 + 49.3717 * tick / 3000.0, 4.0, tick < 10 ? 31.0 : 29.0);
    const Vec3 p_WT = toWorkspace(place, q_M);
    const Target target = targetWithFriction(mesh, p_WT, on_mesh);
    const Target same = targetWithFriction(box, p_WT, on_box);
    ASSERT_EQ(target.status, same.status);
    ASSERT_NEAR((target.p_WP - same.p_WP).norm(), 0.0, 1e-12) << tick;
  }
}

}  // namespace
}  // namespace underact::target
