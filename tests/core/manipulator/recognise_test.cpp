#include <cmath>

#include "tests/core/manipulator/chains.h"

namespace underact::manipulator {
namespace {

using test::sliding;
using test::tipAt;
using test::turning;

Wanted of(chain::Chain chain, Orientation orientation = Orientation::None) {
  Wanted wanted;
  wanted.chain = std::move(chain);
  wanted.orientation = orientation;
  wanted.ko_N_m_per_rad = 0.25;
  return wanted;
}

std::optional<ClosedFormKind> kindOf(Wanted wanted) {
  const Manipulator m = test::made(std::move(wanted));
  EXPECT_EQ(m.closed.has_value(), m.options.method == Method::ClosedForm);
  return m.closed ? std::optional(m.closed->kind) : std::nullopt;
}

/// Two joints at an angle, the second one's axis off the first by a way, the tip at 50 mm along x.
chain::Chain twoTurns(const Vec3& one_W, const Vec3& two_W, const Vec3& p_WJ2 = Vec3::Zero(),
                      const Vec3& p_WV = {0.05, 0, 0}) {
  return test::chainOf({turning(one_W, Vec3::Zero()), turning(two_W, p_WJ2)}, tipAt(p_WV));
}

}  // namespace

TEST(Recognise, EveryChainOfTheTableHasItsForm) {
  EXPECT_EQ(kindOf(of(test::ring())), ClosedFormKind::Circle);
  EXPECT_EQ(kindOf(of(test::ring(-1.0, 2.0))), ClosedFormKind::Circle);
  EXPECT_EQ(kindOf(of(test::ring(), Orientation::Axis)), ClosedFormKind::Circle);
  EXPECT_EQ(kindOf(of(test::ball())), ClosedFormKind::Sphere);
  EXPECT_EQ(kindOf(of(test::ball(), Orientation::Axis)), ClosedFormKind::Sphere);
  EXPECT_EQ(kindOf(of(test::tube())), ClosedFormKind::Cylinder);
  EXPECT_EQ(kindOf(of(test::tube(), Orientation::Axis)), ClosedFormKind::Cylinder);
  const Vec3 z_W = Vec3::UnitZ();
  const chain::Chain slides_first =
      test::chainOf({sliding(-z_W, -0.1, 0.1), turning(z_W, Vec3::Zero())}, tipAt({0.05, 0, 0}));
  EXPECT_EQ(kindOf(of(slides_first)), ClosedFormKind::Cylinder);
  for (const Orientation orientation : test::kOrientations) {  // sliding joints do not turn the tip
    EXPECT_EQ(kindOf(of(test::chainOf({sliding({1, 2, 3})}, tipAt(Vec3::Zero())), orientation)), ClosedFormKind::Line);
    EXPECT_EQ(kindOf(of(test::chainOf({sliding({1, 0, 1}), sliding({-1, 5, 1})}, tipAt(Vec3::Zero())), orientation)),
              ClosedFormKind::Plane);
  }
}

TEST(Recognise, ASphereIsThereWhereverItsCentreIs) {
  // Axis 2 crosses axis 1 above joint 1's own point.
  EXPECT_EQ(kindOf(of(twoTurns(Vec3::UnitZ(), Vec3::UnitY(), {0, 0.02, 0.03}, {0.04, 0, 0.07}))),
            ClosedFormKind::Sphere);
}

TEST(Recognise, LeavesOtherFormsToTheSolver) {
  const Vec3 x_W = Vec3::UnitX(), y_W = Vec3::UnitY(), z_W = Vec3::UnitZ();
  const auto none = [](Wanted wanted) { return !kindOf(std::move(wanted)).has_value(); };
  EXPECT_TRUE(none(of(test::ring(), Orientation::Angle)));
  EXPECT_TRUE(none(of(test::ring(), Orientation::Full)));
  EXPECT_TRUE(none(of(test::ball(), Orientation::Full)));
  EXPECT_TRUE(none(of(test::tube(), Orientation::Full)));
  EXPECT_TRUE(none(of(test::planarArm({0.05, 0.05}))));
  EXPECT_TRUE(none(of(test::scara())));
  Wanted unequal = of(test::ring());
  unequal.kp_N_per_m.y() = 501.0;
  EXPECT_TRUE(none(unequal));
  Wanted bent = of(test::ring());
  bent.spring[0] = 0.1;
  EXPECT_TRUE(none(bent));
  EXPECT_TRUE(none(of(twoTurns(z_W, (y_W + 0.01 * z_W).normalized()))));                        // oblique
  EXPECT_TRUE(none(of(twoTurns(z_W, y_W, {0.001, 0, 0}))));                                     // no common point
  EXPECT_TRUE(none(of(twoTurns(z_W, y_W, Vec3::Zero(), {0.05, 0.001, 0}))));                    // not the whole sphere
  EXPECT_TRUE(none(of(twoTurns(z_W, y_W, Vec3::Zero(), {0.03, 0, 0.04}), Orientation::Axis)));  // z not radial
  EXPECT_FALSE(none(of(twoTurns(z_W, y_W, Vec3::Zero(), {0.03, 0, 0.04}), Orientation::None)));
  for (const double limit_rad : {-1.0, 1.0}) {
    chain::Chain limited = test::ball();
    (limit_rad < 0.0 ? limited.joints[0].min : limited.joints[1].max) = limit_rad;
    EXPECT_TRUE(none(of(limited)));
  }
  EXPECT_TRUE(none(of(test::chainOf({turning(z_W, Vec3::Zero()), sliding(x_W)}, tipAt({0.05, 0, 0})))));
  EXPECT_TRUE(none(of(test::chainOf({sliding(x_W), sliding((x_W + y_W).normalized())}, tipAt(Vec3::Zero())))));
  EXPECT_TRUE(none(of(test::chainOf({sliding(x_W), sliding(y_W), sliding(z_W)}, tipAt(Vec3::Zero())))));
}

TEST(Recognise, WhereItIsAskedForTheSolverTakesWhatHasAForm) {
  Wanted wanted = of(test::ring());
  wanted.method = Method::Iterative;
  const Manipulator m = test::made(wanted);
  EXPECT_FALSE(m.closed);
  EXPECT_EQ(m.options.method, Method::Iterative);
}

}  // namespace underact::manipulator
