#include "core/target/friction.h"

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

TEST(Friction, HoldsUpToTheStaticShareAndDragsByTheDynamicOne) {
  const Constraint floor = rough(kFloor, Side::Outside, {0.5, 0.3});
  State state;
  const double depth_m = 0.002;
  EXPECT_EQ(targetWithFriction(floor, {0, 0, -depth_m}, state).p_WP, Vec3::Zero());
  double x_m = 0.0;
  for (; x_m <= 0.5 * depth_m; x_m += 1e-5) {
    ASSERT_EQ(targetWithFriction(floor, {x_m, 0, -depth_m}, state).p_WP, Vec3::Zero()) << "sticks at " << x_m;
  }
  // It lets go, and drags behind by the dynamic share from then on (it sticks again and lets go once more: 0.3 to 0.5).
  EXPECT_NEAR(shareOf(targetWithFriction(floor, {x_m, 0, -depth_m}, state), {x_m, 0, -depth_m}), 0.3, 1e-12);
  for (int tick = 0; tick < 1000; ++tick) {
    x_m += 1e-5;
    const double share = shareOf(targetWithFriction(floor, {x_m, 0, -depth_m}, state), {x_m, 0, -depth_m});
    ASSERT_GE(share, 0.3 - 1e-9);
    ASSERT_LE(share, 0.5 + 1e-9);
  }
  const Vec3 back_W(x_m - 1e-4, 0, -depth_m);  // the hand turns round: the target stays where it is first
  const Vec3 held_W = state.grip.p_WG;
  EXPECT_EQ(targetWithFriction(floor, back_W, state).p_WP, held_W);
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
  EXPECT_FALSE(state.grip.holds);
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
      ASSERT_LE((target.p_WP - smooth.p_WP).norm(), 0.6 * smooth.distance_m + 1e-6) << "tick " << tick;
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
