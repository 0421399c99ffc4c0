#include "core/chain/closed_form.h"

#include <algorithm>

#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

using test::Angles;

// What rounding makes of a pose, in reaches and in rad: a few ulp of the joints, each seen over the whole arm. 1e-12 is
// what may become one on the edge, and does in a sweep as wide as these now and then.
constexpr double kPose = 4e-12;

struct Known {
  Chain chain;
  SphericalWristArm arm;
};

Known known(const test::Arm& arm) {
  Chain chain = arm.chain();
  const SphericalWristArm recognised = recognise(chain).value();
  return {std::move(chain), recognised};
}

/// An arm of any angles that the solution knows: axis 1 askew, axes 2 and 3 opposed or not, a wrist of any angles.
Known anyKnown(test::property::Random& random, bool right_wrist) {
  const Vec3 across = random.direction(), p_WC = random.inBox(0.5);
  const double sense = random.below(2) == 0 ? 1.0 : -1.0;
  Chain chain;
  chain.joints = {{JointType::Revolute, random.direction(), random.inBox(0.3)},
                  {JointType::Revolute, across, random.inBox(0.3)},
                  {JointType::Revolute, sense * across, random.inBox(0.3)}};
  Vec3 axis_W = random.direction();
  for (int i = 0; i < 3; ++i) {
    const Vec3 next_W = random.direction();
    chain.joints.push_back({JointType::Revolute, axis_W, p_WC + random.between(-0.2, 0.2) * axis_W});
    axis_W = right_wrist ? Vec3(axis_W.cross(next_W).normalized()) : next_W;
  }
  chain.X_WT_home = test::anyPose(random, 0.5);
  const std::optional<SphericalWristArm> arm = recognise(chain);
  return arm ? Known{chain, *arm} : anyKnown(random, right_wrist);
}

double between(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2 * kPi));
}

double apart(const Angles& a, const Angles& b) {
  double max_rad = 0.0;
  for (std::size_t i = 0; i < 6; ++i) max_rad = std::max(max_rad, between(a[i], b[i]));
  return max_rad;
}

Angles anyAngles(test::property::Random& random) {
  Angles q{};
  for (double& one : q) one = random.between(-kPi, kPi);
  return q;
}

/// How far a solution's pose is from the wanted one; reaches and rad, the larger.
double miss(const Known& known, const Solution& one, const Pose& X_WT) {
  const Pose X = forward(known.chain, one.q);
  return std::max(test::wayBetween(X, X_WT) / known.arm.reach_m, test::turnBetween(X, X_WT));
}

/// Every exact solution reaches X_WT, no two are the same, and no number is NaN or beyond (-pi, pi].
void expectAllReach(const Known& known, const Solutions& found, const Pose& X_WT, double within) {
  ASSERT_LE(found.exact, found.count);
  ASSERT_LE(found.count, 8U);
  for (std::size_t i = 0; i < found.count; ++i) {
    const Solution& one = found.all[i];
    EXPECT_EQ(one.exact, i < found.exact);
    for (const double angle_rad : one.q) {
      EXPECT_GT(angle_rad, -kPi);
      EXPECT_LE(angle_rad, kPi);
    }
    if (one.exact) {
      EXPECT_LE(miss(known, one, X_WT), within) << i;
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Solution& other = found.all[j];
      EXPECT_FALSE(one.shoulder == other.shoulder && one.elbow == other.elbow && one.wrist == other.wrist);
    }
  }
}

double nearestTo(const Solutions& found, const Angles& q) {
  double min_rad = kInfinity;
  for (std::size_t i = 0; i < found.exact; ++i) min_rad = std::min(min_rad, apart(found.all[i].q, q));
  return min_rad;
}

/// How far q is from where two solutions meet: 0 there. What q loses in digits, its inverse gains.
double margin(const Known& known, const Angles& q) {
  const Jacobian J = jacobian(known.chain, q);
  Eigen::Matrix<double, 6, 6> scaled = J;
  scaled.topRows<3>() /= known.arm.reach_m;
  return scaled.jacobiSvd().singularValues()(5);
}

void expectRoundTrips(const Known& known, test::property::Random& random, int draws, bool eight) {
  for (int draw = 0; draw < draws && !testing::Test::HasFailure(); ++draw) {
    const Angles q = anyAngles(random);
    const Pose X_WT = forward(known.chain, q);
    const Solutions found = solveAll(known.arm, X_WT);
    expectAllReach(known, found, X_WT, kPose);
    const double away = margin(known, q);
    if (away > 1e-6) {
      EXPECT_LE(nearestTo(found, q), 1e-13 / away) << "draw " << draw;
    }
    if (away > 1e-3) {
      EXPECT_EQ(found.exact % 2, 0U) << "draw " << draw;
    }
    if (eight) {
      EXPECT_EQ(found.exact, 8U) << "draw " << draw;
    }
  }
}

TEST(ClosedForm, FindsItsWayBackOnEveryArm) {
  test::property::Random random({20});
  for (const test::Arm& arm : test::arms()) {
    SCOPED_TRACE(arm.name);
    expectRoundTrips(known(arm), random, test::property::sweep(2000, 200000), false);
  }
}

TEST(ClosedForm, OfTheOmniIsEightfoldEverywhere) {  // no shoulder offset, a wrist of right angles: each step has both
  test::property::Random random({21});
  expectRoundTrips(known(test::omni()), random, test::property::sweep(2000, 200000), true);
}

TEST(ClosedForm, OfThePumaIsEightfoldWellInside) {
  test::property::Random random({22});
  const Known puma = known(test::puma());
  int eightfold = 0;
  for (int draw = 0; draw < 2000; ++draw) {
    Angles q = anyAngles(random);
    const Pose X_WT = forward(puma.chain, q);
    const double off_axis_m = X_WT.translation().head<2>().norm(), from_shoulder_m = X_WT.translation().norm();
    if (off_axis_m < 0.1502 || from_shoulder_m > 0.86) continue;  // 0.1501: the shoulder's offset
    ++eightfold;
    EXPECT_EQ(solveAll(puma.arm, X_WT).exact, 8U);
  }
  EXPECT_GT(eightfold, 1000);
}

TEST(ClosedForm, KnowsArmsWhoseAxesStandAskew) {
  test::property::Random random({23});
  for (int arm = 0; arm < test::property::sweep(300, 10000); ++arm) {
    expectRoundTrips(anyKnown(random, arm % 2 == 0), random, 20, false);
    if (HasFailure()) FAIL() << "arm " << arm;
  }
}

TEST(ClosedForm, OfTheIrb120ByHand) {  // home: the upper arm up, the wrist straight at q5 = 0
  const Known irb = known(test::irb120());
  const Solutions found = solveAll(irb.arm, irb.chain.X_WT_home);
  EXPECT_LE(nearestTo(found, Angles{}), 1e-12);
  expectAllReach(irb, found, irb.chain.X_WT_home, kPose);
}

TEST(ClosedForm, NamesTheBranches) {  // branch and joint go together: one sign, one answer
  const Known omni = known(test::omni());
  const Pose X_WT = forward(omni.chain, Angles{0.2, 0.8, 0.3, 0.5, 0.9, -0.4});
  const Solutions found = solveAll(omni.arm, X_WT);
  ASSERT_EQ(found.exact, 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    const Solution& one = found.all[i];
    EXPECT_EQ(one.wrist, one.q[4] > 0 ? 1 : -1);  // the Omni's wrist is straight at 0, its elbow at pi / 2
    EXPECT_EQ(one.elbow, std::abs(one.q[2]) > kPi / 2 ? 1 : -1);
    EXPECT_EQ(one.shoulder, between(one.q[0], found.all[0].q[0]) < 1e-9 ? 1 : -1);
  }
}

TEST(ClosedForm, IsTheSameInPairs) {  // a spherical wrist of right angles: q4 + pi, -q5, q6 + pi
  const Known puma = known(test::puma());
  const Solutions found = solveAll(puma.arm, forward(puma.chain, Angles{0.2, -0.8, 0.3, 0.5, 0.9, -0.4}));
  ASSERT_EQ(found.exact, 8U);
  for (std::size_t i = 0; i < 8; i += 2) {
    const Angles& a = found.all[i].q;
    EXPECT_LE(apart({a[0], a[1], a[2], a[3] + kPi, -a[4], a[5] + kPi}, found.all[i + 1].q), 1e-12);
  }
}

}  // namespace
}  // namespace underact::chain
