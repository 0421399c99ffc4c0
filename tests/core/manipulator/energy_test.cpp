#include "core/manipulator/energy.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/manipulator/follow.h"
#include "core/manipulator/global.h"
#include "tests/core/manipulator/chains.h"

namespace underact::manipulator {
namespace {

using test::energyAt;

/// Any chain of count joints with any gains, and springs in every third.
Manipulator anyManipulator(test::property::Random& random, std::size_t count, Orientation orientation) {
  Wanted wanted;
  wanted.chain = test::anyChain(random, count);
  wanted.orientation = orientation;
  wanted.kp_N_per_m = {random.between(100, 900), random.between(100, 900), random.between(100, 900)};
  wanted.ko_N_m_per_rad = random.between(0.1, 2.0);
  for (std::size_t i = 0; i < count && random.below(3) == 0; ++i) {
    wanted.spring[i] = random.between(0.1, 1.0);
    wanted.rest[i] = random.between(-1.0, 1.0);
  }
  return test::made(wanted);
}

/// One revolute joint among sliding ones; the angle of z about it.
Manipulator anyAngle(test::property::Random& random, std::size_t count) {
  std::vector<chain::Joint> joints(count);
  const std::size_t turning = random.below(count);
  for (std::size_t i = 0; i < count; ++i) {
    joints[i] = i == turning ? test::turning(random.direction(), random.inBox(0.1)) : test::sliding(random.direction());
  }
  Wanted wanted;
  wanted.chain = test::chainOf(joints, test::anyPose(random, 0.1));
  wanted.orientation = Orientation::Angle;
  wanted.ko_N_m_per_rad = random.between(0.1, 2.0);
  return test::made(wanted);
}

/// Whether the energy has a kink near there: half a turn between tip and stylus, as a whole turn or about the axis.
bool nearAKink(const Manipulator& m, const Energy& at) {
  const bool wraps = m.orientation == Orientation::Angle || m.orientation == Orientation::Full;
  return wraps && at.e_o_W.norm() > kPi - 0.05;
}

/// Central differences of step h have errors of h^2 / 6 times the third derivative and of rounding / h. The energy's
/// scale is 1/2 K e^2 and its derivatives over a joint grow by the joint's own unit, so with h = 1e-5 rad or 1e-6 m
/// both are under 1e-9 of that scale.
void expectSlopesMatch(const Manipulator& m, const Pose& X_WT, const Values& theta) {
  const Energy at = energyAt(m, X_WT, theta);
  if (nearAKink(m, at)) return;
  const double scale = m.kp_N_per_m.maxCoeff() * (at.e_p_W.squaredNorm() + 0.04) + 10.0 * m.ko_N_m_per_rad + 4.0;
  Hessian H;
  Values spread{};
  curvature(m, at, true, H, spread);
  const std::size_t count = m.chain.joints.size();
  ASSERT_EQ(H.size, count);
  for (std::size_t i = 0; i < count; ++i) {
    const double unit = m.chain.joints[i].type == chain::JointType::Revolute ? 1.0 : 10.0;  // per 0.1 m
    const double h = 1e-5 / unit;
    Values less = theta, more = theta;
    less[i] -= h, more[i] += h;
    const Energy low = energyAt(m, X_WT, less), high = energyAt(m, X_WT, more);
    ASSERT_NEAR(at.slope[i], (high.energy_J - low.energy_J) / (2.0 * h), 1e-8 * scale * unit) << i;
    for (std::size_t j = i; j < count; ++j) {
      const double other = m.chain.joints[j].type == chain::JointType::Revolute ? 1.0 : 10.0;
      ASSERT_NEAR(H.a[j][i], (high.slope[j] - low.slope[j]) / (2.0 * h), 1e-7 * scale * unit * other) << j << i;
    }
  }
}

/// The least energy near where theta is, if a hundred steps lead there (nearly parallel slides may have far to go).
std::optional<Energy> settled(const Manipulator& m, const Pose& X_WT, const Values& theta) {
  Energy at = energyAt(m, X_WT, theta);
  return descend(m, X_WT, 100, at).left < 1e-9 ? std::optional(at) : std::nullopt;
}

}  // namespace

TEST(Energy, ItsSlopeAndCurvatureAreThoseOfDifferences) {
  test::property::Random random(test::property::Seed{20070601});
  for (int i = 0; i < test::property::sweep(400, 20'000); ++i) {
    const std::size_t count = 1 + random.below(8);
    for (const Orientation orientation : test::kOrientations) {
      const Manipulator m = anyManipulator(random, count, orientation);
      expectSlopesMatch(m, test::anyPose(random, 0.2), test::anyPlace(random, m));
      if (HasFatalFailure()) FAIL() << i << " of " << count << " joints";
    }
    const Manipulator m = anyAngle(random, count);
    expectSlopesMatch(m, test::anyPose(random, 0.2), test::anyPlace(random, m));
    if (HasFatalFailure()) FAIL() << i << " the angle";
  }
}

TEST(Energy, WithoutTheSecondOrderItsCurvatureIsThatOfTheJacobianAlone) {
  test::property::Random random(test::property::Seed{20070602});
  for (int i = 0; i < 100; ++i) {
    const Manipulator m = anyManipulator(random, 5, Orientation::Full);
    const Energy at = energyAt(m, test::anyPose(random, 0.2), test::anyPlace(random, m));
    Hessian H;
    Values spread{};
    curvature(m, at, false, H, spread);
    Vec6 gains;
    gains << m.kp_N_per_m, Vec3::Constant(m.ko_N_m_per_rad);
    const Eigen::MatrixXd wanted = at.tip.J.transpose() * gains.asDiagonal() * at.tip.J;
    for (std::size_t j = 0; j < 5; ++j) {
      for (std::size_t k = 0; k <= j; ++k) {
        const double spring = j == k ? m.spring[j] : 0.0;
        ASSERT_NEAR(H.a[j][k], wanted(static_cast<int>(j), static_cast<int>(k)) + spring, 1e-11);
      }
      ASSERT_GE(spread[j], H.a[j][j] * (1.0 - 1e-14));
    }
  }
}

TEST(Energy, WithItsSpreadTheCurvatureIsPositiveAnywhere) {  // Gershgorin: what the descent's damping relies on
  test::property::Random random(test::property::Seed{20070603});
  for (int i = 0; i < test::property::sweep(2'000, 100'000); ++i) {
    const std::size_t count = 1 + random.below(8);
    const Manipulator m = anyManipulator(random, count, test::kOrientations[random.below(3)]);
    const Energy at = energyAt(m, test::anyPose(random, 0.3), test::anyPlace(random, m));
    Hessian H;
    Values spread{};
    curvature(m, at, true, H, spread);
    for (std::size_t j = 0; j < count; ++j) {
      H.a[j][j] += spread[j] * (1.0 + 1e-12);
      H.b[j] = 0.0;
    }
    ASSERT_TRUE(solveInPlace(H)) << i;
  }
}

TEST(Energy, TheForceOnTheHandIsTheSlopeOfTheLeastEnergyOverItsPlaceAndTheMomentOverItsTurn) {
  test::property::Random random(test::property::Seed{20070604});
  int compared = 0;
  for (int i = 0; i < test::property::sweep(300, 20'000); ++i) {
    const std::size_t count = 1 + random.below(6);
    const Orientation orientation = test::kOrientations[random.below(3)];
    Manipulator m = i % 4 == 3 ? anyAngle(random, count) : anyManipulator(random, count, orientation);
    m.options.tolerance = 1e-13;
    const Pose X_WT = test::anyPose(random, 0.2);
    const std::optional<Energy> found = settled(m, X_WT, test::anyPlace(random, m));
    if (!found || nearAKink(m, *found) || found->weight < 1.0) continue;
    const Energy& at = *found;
    // A step of 1e-5 m and 1e-4 rad: the envelope's own curvature may be large where a minimum is shallow, and there
    // the steps of both sides disagree; the smaller step tells such places from wrong forces.
    for (Eigen::Index k = 0; k < 3; ++k) {
      // Of an angle only the turn about its own axis is the tip's as it is the stylus's.
      const bool angle = m.orientation == Orientation::Angle;
      const Vec3 about_W = angle ? m.chain.joints[m.turning].axis_W : Vec3(Vec3::Unit(k));
      double pulled[2] = {}, turned[2] = {};
      for (int fine = 0; fine < 2; ++fine) {
        const double h_m = fine ? 2e-6 : 1e-5, h_rad = fine ? 2e-5 : 1e-4;
        double moved_J[2] = {}, twisted_J[2] = {};
        for (int side = 0; side < 2; ++side) {
          const double sign = side ? 1.0 : -1.0;
          const Vec3 way_W = sign * h_m * Vec3::Unit(k);
          const Pose moved = test::poseOf(X_WT.linear(), X_WT.translation() + way_W);
          const Pose twisted = test::poseOf(test::about(about_W, sign * h_rad) * X_WT.linear(), X_WT.translation());
          moved_J[side] = settled(m, moved, at.theta).value_or(at).energy_J;
          twisted_J[side] = settled(m, twisted, at.theta).value_or(at).energy_J;
        }
        pulled[fine] = (moved_J[1] - moved_J[0]) / (2.0 * h_m);
        turned[fine] = (twisted_J[1] - twisted_J[0]) / (2.0 * h_rad);
      }
      const double scale_N = at.f_W.norm() + 1.0, scale_N_m = at.m_W.norm() + m.ko_N_m_per_rad;
      if (std::abs(pulled[0] - pulled[1]) > 3e-7 * scale_N) continue;
      if (std::abs(turned[0] - turned[1]) > 3e-7 * scale_N_m) continue;
      ASSERT_NEAR(at.f_W[k], -pulled[1], 1e-6 * scale_N) << i;
      ASSERT_NEAR(at.m_W.dot(about_W), -turned[1], 1e-6 * scale_N_m) << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, test::property::sweep(600, 40'000));
}

TEST(Energy, TheAngleCountsLessAndLessTowardsTheAxisAndNeverJumps) {
  const Vec3 axis_W = Vec3(1, -2, 3).normalized(), across_W = axis_W.unitOrthogonal();
  const auto leaning = [&](double lean_rad) {
    return weightOfAngle(axis_W, std::cos(lean_rad) * axis_W + std::sin(lean_rad) * across_W);
  };
  EXPECT_EQ(weightOfAngle(axis_W, axis_W), 0.0);
  EXPECT_EQ(weightOfAngle(axis_W, -axis_W), 0.0);
  EXPECT_EQ(leaning(5.001 * kRadPerDegree), 1.0);
  EXPECT_EQ(leaning(kPi / 2), 1.0);
  EXPECT_NEAR(leaning(2.5 * kRadPerDegree), 0.5, 1e-12);
  EXPECT_NEAR(leaning(kPi - 2.5 * kRadPerDegree), 0.5, 1e-12);
  double last = 0.0;
  for (double lean_deg = 0.0; lean_deg < 6.0; lean_deg += 0.01) {
    const double now = leaning(lean_deg * kRadPerDegree);
    ASSERT_GE(now, last);
    ASSERT_LE(now - last, 1.5 * 0.01 / 5.0 * 1.001);  // the steepest that a smooth step of 5 degrees is
    last = now;
  }
}

TEST(Energy, NotFiniteInNotFiniteOut) {
  Wanted wanted;
  wanted.chain = test::ball();
  wanted.orientation = Orientation::Axis;
  wanted.ko_N_m_per_rad = 0.1;
  const Manipulator m = test::made(wanted);
  Pose X_WT = Pose::Identity();
  EXPECT_FALSE(std::isfinite(energyAt(m, X_WT, {kNotANumber}).energy_J));
  X_WT.translation().x() = kInfinity;
  EXPECT_FALSE(std::isfinite(energyAt(m, X_WT, {}).energy_J));
}

}  // namespace underact::manipulator
