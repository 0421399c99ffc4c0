#include "core/manipulator/closed_form.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/manipulator/follow.h"
#include "core/manipulator/global.h"
#include "tests/core/manipulator/chains.h"

namespace underact::manipulator {
namespace {

using test::sliding;
using test::turning;

/// Limits about home or none at all; in every fourth from one side alone.
void limit(test::property::Random& random, chain::Joint& joint, double half) {
  const std::size_t kind = random.below(4);
  const double min = random.between(-half, half);
  if (kind == 1 || kind == 2) joint.min = min;
  if (kind == 1 || kind == 3) joint.max = min + random.between(0.1, 2.0) * half;
}

/// Any chain with a closed form, anywhere and any way round.
chain::Chain anyClosed(test::property::Random& random, Orientation orientation) {
  const Vec3 axis_W = random.direction(), p_WJ = random.inBox(0.05);
  const Pose X_WV = test::anyPose(random, 0.1);
  std::vector<chain::Joint> joints;
  switch (random.below(5)) {
    case 0:
      joints = {turning(axis_W, p_WJ)};
      break;
    case 1:
      joints = {turning(axis_W, p_WJ), sliding(random.below(2) == 0 ? axis_W : Vec3(-axis_W))};
      if (random.below(2) == 0) std::swap(joints[0], joints[1]);
      break;
    case 2:
      joints = {sliding(axis_W)};
      break;
    case 3:
      joints = {sliding(axis_W), sliding(axis_W.unitOrthogonal())};
      break;
    default: {
      // The sphere: the tip across joint 2, its z along the radius, in or out.
      const Vec3 two_W = axis_W.unitOrthogonal();
      const Vec3 radial_W = test::about(two_W, random.between(-1, 1)) * two_W.cross(axis_W);
      Pose X = test::poseOf(Mat3::Identity(), p_WJ + random.between(0.02, 0.08) * radial_W);
      const Vec3 z_W = orientation == Orientation::None ? random.direction()
                       : random.below(2) == 0           ? radial_W
                                                        : Vec3(-radial_W);
      X.linear().col(2) = z_W;
      X.linear().col(0) = z_W.unitOrthogonal();
      X.linear().col(1) = z_W.cross(X.linear().col(0));
      return test::chainOf({turning(axis_W, p_WJ + random.between(-0.1, 0.1) * axis_W),
                            turning(two_W, p_WJ + random.between(-0.1, 0.1) * two_W)},
                           X);
    }
  }
  for (chain::Joint& joint : joints) limit(random, joint, joint.type == chain::JointType::Revolute ? 2.5 : 0.05);
  return test::chainOf(std::move(joints), X_WV);
}

}  // namespace

TEST(ClosedForm, ItIsTheGlobalMinimumThatTheSolverFinds) {
  test::property::Random random(test::property::Seed{20070611});
  int seen[5] = {};
  for (int i = 0; i < test::property::sweep(1'000, 30'000); ++i) {
    Wanted wanted;
    wanted.orientation = random.below(2) == 0 ? Orientation::None : Orientation::Axis;
    wanted.chain = anyClosed(random, wanted.orientation);
    wanted.kp_N_per_m = Vec3::Constant(random.between(100, 900));
    wanted.ko_N_m_per_rad = random.between(0.1, 2.0);
    wanted.tolerance = 1e-12;
    wanted.method = Method::ClosedForm;
    const Manipulator closed = test::made(wanted);
    wanted.method = Method::Iterative;
    const Manipulator iterative = test::made(wanted);
    ++seen[static_cast<int>(closed.closed->kind)];
    const Pose X_WT = test::anyPose(random, 0.15);
    const Global by_form = minEnergy(closed, X_WT), by_search = minEnergy(iterative, X_WT);
    ASSERT_TRUE(by_form.is_unique) << i;
    const double scale_J = by_search.at.energy_J + 1e-3;
    ASSERT_NEAR(by_form.at.energy_J, by_search.at.energy_J, 1e-13 * scale_J) << i;
    for (std::size_t j = 0; j < closed.chain.joints.size(); ++j) {
      ASSERT_GE(by_form.at.theta[j], closed.chain.joints[j].min - 1e-14) << i;
      ASSERT_LE(by_form.at.theta[j], closed.chain.joints[j].max + 1e-14) << i;
    }
    // Where two places are nearly as good a rounding may choose; and a minimum is as flat as its curvature is small.
    if (by_search.second_J < 1e-6 * scale_J) continue;
    ASSERT_LE((by_form.at.tip.X_WT.translation() - by_search.at.tip.X_WT.translation()).norm(), 1e-9) << i;
    ASSERT_LE((by_form.at.f_W - by_search.at.f_W).norm(), 1e-6) << i;
  }
  for (const int count : seen) EXPECT_GT(count, 50);
}

TEST(ClosedForm, OfManyTurnsItTakesTheOneNearestToWhereItWas) {
  test::property::Random random(test::property::Seed{20070612});
  for (int i = 0; i < test::property::sweep(20'000, 200'000); ++i) {
    double min_rad = random.between(-10.0, 0.0), max_rad = min_rad + random.between(6.5, 20.0);
    const std::size_t open = random.below(3);
    if (open == 1) min_rad = -kInfinity;
    if (open == 2) max_rad = kInfinity;
    Wanted wanted;
    wanted.chain = test::ring(min_rad, max_rad);
    const Manipulator m = test::made(wanted);
    const double best_rad = random.between(-kPi, kPi);
    const Vec3 p_WT = 0.07 * Vec3(std::cos(best_rad), std::sin(best_rad), 0.0);
    const double near_rad = random.between(std::max(min_rad, -12.0), std::min(max_rad, 25.0));
    const double theta_rad = closedForm(m, test::tipAt(p_WT), {near_rad}).theta[0];
    double nearest_rad = kInfinity;
    for (int turn = -6; turn <= 6; ++turn) {
      const double one_rad = best_rad + 2.0 * kPi * turn;
      if (one_rad < min_rad || one_rad > max_rad) continue;
      if (std::abs(one_rad - near_rad) < std::abs(nearest_rad - near_rad)) nearest_rad = one_rad;
    }
    ASSERT_NEAR(theta_rad, nearest_rad, 1e-13)
        << "limits " << min_rad << " " << max_rad << ", best " << best_rad << ", was " << near_rad;
  }
}

TEST(ClosedForm, BeyondItsLimitsItIsAtTheOneThatIsNearerRound) {
  Wanted wanted;
  wanted.chain = test::ring(-0.5, 1.0);
  const Manipulator m = test::made(wanted);
  const auto at = [&](double angle_rad) {
    return closedForm(m, test::tipAt(0.06 * Vec3(std::cos(angle_rad), std::sin(angle_rad), 0)), {}).theta[0];
  };
  EXPECT_EQ(at(1.2), 1.0);
  EXPECT_EQ(at(-0.7), -0.5);
  EXPECT_EQ(at(0.25 + kPi - 0.01), 1.0);   // just before opposite the middle
  EXPECT_EQ(at(0.25 - kPi + 0.01), -0.5);  // just after
  EXPECT_NEAR(at(0.9), 0.9, 1e-15);
}

TEST(ClosedForm, OnTheAxisItStaysWhereItWas) {
  for (const chain::Chain& chain : {test::ring(), test::ball(), test::tube()}) {
    Wanted wanted;
    wanted.chain = chain;
    const Manipulator m = test::made(wanted);
    const Closed closed = closedForm(m, test::tipAt(Vec3::Zero()), {0.7, 0.0});
    EXPECT_FALSE(closed.is_unique);
    EXPECT_EQ(closed.theta[0], 0.7);
    EXPECT_FALSE(minEnergy(m, test::tipAt(Vec3::Zero())).is_unique);
    State state;
    const Followed followed = follow(m, test::tipAt(Vec3::Zero()), 1e-3, state);
    EXPECT_FALSE(followed.is_unique);
    EXPECT_EQ(followed.p_WP, Vec3::Zero());
    ASSERT_TRUE(follow(m, test::tipAt({0, 0.06, 0}), 1e-3, state).is_unique);
    const Followed after = follow(m, test::tipAt(Vec3::Zero()), 1e-3, state);  // with a past
    EXPECT_TRUE(after.is_unique);
    EXPECT_LE((after.p_WP - Vec3(0, 0.05, 0)).norm(), 1e-16);
  }
}

TEST(ClosedForm, AtAPoleTheSphereKeepsItsFirstJoint) {
  Wanted wanted;
  wanted.chain = test::ball();
  const Manipulator m = test::made(wanted);
  for (const double side : {-1.0, 1.0}) {
    const Closed closed = closedForm(m, test::tipAt({0, 0, 0.08 * side}), {2.2, 0.3});
    EXPECT_TRUE(closed.is_unique);
    EXPECT_EQ(closed.theta[0], 2.2);
    EXPECT_NEAR(closed.theta[1], side * kPi / 2, 1e-15);
  }
}

TEST(ClosedForm, OfTheTwoWaysToAPlaceOfTheSphereItTakesTheNearer) {
  Wanted wanted;
  wanted.chain = test::ball();
  const Manipulator m = test::made(wanted);
  test::property::Random random(test::property::Seed{20070613});
  for (int i = 0; i < 1000; ++i) {
    const Values near{random.between(-kPi, kPi), random.between(-kPi, kPi)};
    const Vec3 p_WT = test::energyAt(m, Pose::Identity(), near).tip.X_WT.translation() + 0.001 * random.direction();
    const Values theta = closedForm(m, test::tipAt(p_WT), near).theta;
    if (std::abs(std::cos(near[1])) < 0.1) continue;  // near the pole joint 1 may go far
    ASSERT_LE(std::abs(wrapped(theta[0] - near[0])), 0.3) << i;
    ASSERT_LE(std::abs(wrapped(theta[1] - near[1])), 0.03) << i;
  }
}

}  // namespace underact::manipulator
