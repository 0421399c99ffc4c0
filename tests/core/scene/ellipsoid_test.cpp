#include "core/scene/compile.h"
#include "core/scene/mirror.h"
#include "core/scene/write.h"
#include "core/target/placing.h"
#include "tests/core/scene/scene_support.h"
#include "tests/support/tick_hand.h"

namespace underact::scene {
namespace {

const Mat3 kQuarterTurn = (Mat3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();  // about z: x goes to y

Description ellipsoidIn(const std::string& keys) {
  return readScene(test::sceneWith(R"({"type": "ellipsoid", "center_mm": [10, 0, 0], "semi_axes_mm": [40, 20, 20],
      "R_WB": [[0, -1, 0], [1, 0, 0], [0, 0, 1]])" +
                                   keys + "}"),
                   "f")
      .value();
}
target::Goal ellipsoidGoal(const Description& scene) {
  return compile(scene).value().entries.at(0).constraint.goal;
}

TEST(Ellipsoid, ByHandOutsideInsideAndOnTheLongAxis) {  // semi-axes 2, 1, 1, the long one along y
  const shape::Ellipsoid held = shape::makeEllipsoid({0, 0, 1}, {2, 1, 1}, kQuarterTurn, {}).value();
  const shape::Nearest outside = closestPoint(held, {0, 5, 1}), inside = closestPoint(held, {0.75, 0, 1});
  EXPECT_LE((outside.p_WP - Vec3(0, 2, 1)).norm(), 1e-15);
  EXPECT_NEAR(outside.height_m, 3.0, 1e-15);
  EXPECT_LE((inside.p_WP - Vec3(1, 0, 1)).norm(), 1e-15);
  EXPECT_NEAR(inside.height_m, -0.25, 1e-15);
  const shape::Nearest middle = closestPoint(held, {0, 0.75, 1});  // a ring is nearest: y 1, 1/2 sqrt 3 from the axis
  EXPECT_EQ(middle.status, shape::Status::NotUnique);
  EXPECT_EQ(middle.p_WP, Vec3(0, 0.75, 1));
  EXPECT_NEAR(middle.height_m, -std::sqrt(0.8125), 1e-15);
}

TEST(Ellipsoid, WithEqualAxesIsTheSphereAndScaledTwiceIsScaledOnce) {
  test::Random random(test::Seed{20261128});
  for (int draw = 0; draw < test::sweep(2000, 100'000); ++draw) {
    const Vec3 c = random.inBox(0.1), p_WT = random.inBox(0.3), scale(0.3, random.between(0.2, 1.0), 0.9);
    const Mat3 R = Eigen::AngleAxisd(random.between(-3.0, 3.0), random.direction()).toRotationMatrix();
    const shape::Sphere sphere{c, 0.05};
    const shape::Ellipsoid round = shape::makeEllipsoid(c, Vec3::Constant(0.05), R, {}).value();
    ASSERT_LE((closestPoint(sphere, p_WT).p_WP - closestPoint(round, p_WT).p_WP).norm(), 1e-13);
    const shape::Nearest once = closestPoint(scaled(sphere, scale), p_WT),
                         again = closestPoint(scaled(round, scale), p_WT);
    ASSERT_NEAR(once.height_m, again.height_m, 1e-14);
  }
}

TEST(Ellipsoid, EveryProblemIsNamed) {
  EXPECT_EQ(shape::makeEllipsoid({0, kNotANumber, 0}, {1, 0, 1}, Mat3::Zero(), {}).problems().size(), 3U);
  const std::string at = "constraints[0].";
  EXPECT_EQ(
      test::joined(test::problemsIn(test::sceneWith(
          R"({"type": "ellipsoid", "center_mm": [0, 0, 0], "semi_axes_mm": [1, -2, 3], "influence": {"t": 1}})"))),
      "2:67: " + at + "semi_axes_mm[1]: This must be above 0 mm; here it is -2.\n2:75: " + at +
          "influence: An ellipsoid has no influence; only a circle, a cylinder and a sphere have. Remove it.\n");
}

TEST(Ellipsoid, AWallPushesOutAlongItsNormalAndRubs) {
  test::Hand hand(compile(ellipsoidIn(R"(, "side": "outside", "friction": {"static": 0.5})")).value());
  hand.settle({0.010, 0.041, 0.0});
  EXPECT_EQ(hand.report().held[0].status, target::Status::Free);
  hand.settle({0.010, 0.038, 0.0});  // 2 mm below the end of the long axis
  EXPECT_LE((hand.report().f_T_W - Vec3(0, 1.0, 0)).norm(), 1e-9);
  hand.settle({0.0105, 0.038, 0.0});  // a quarter of the depth aside: it sticks
  EXPECT_NEAR(hand.report().f_T_W.x(), -0.25, 1e-9);
}

TEST(Ellipsoid, IsMirroredAndCarriedAsABoxIs) {
  const Description scene = ellipsoidIn(R"(, "control": {"anisotropy": "euclidean"})");
  const auto seen = std::get<Ellipsoid>(mirrored(scene).constraints[0].shape);
  EXPECT_EQ(seen, (Ellipsoid{{-10, 0, 0}, {40, 20, 20}, kQuarterTurn.transpose()}));
  target::Goal from = ellipsoidGoal(scene);
  const target::Goal to = ellipsoidGoal(mirrored(scene));
  const target::Placing begin = placingOf(from), end = placingOf(to);
  EXPECT_EQ(begin.kind, 8);
  put(from, between(begin, end, 0.5));
  const auto& half = std::get<shape::Ellipsoid>(std::get<target::NearestOnShape>(from).shape);
  EXPECT_LE((half.p_WC).norm(), 1e-18);
  EXPECT_TRUE(half.R_WB.isIdentity(1e-12));
  put(from, end);
  EXPECT_TRUE(isSame(placingOf(from), end));
}

}  // namespace
}  // namespace underact::scene
