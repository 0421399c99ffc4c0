#include <gtest/gtest.h>

#include "core/arm/branches.h"
#include "core/arm/follower.h"
#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/arm/model.h"
#include "core/arm/statics.h"
#include "core/chain/closed_form.h"
#include "core/chain/numeric_inverse.h"
#include "core/chain/three_parallel.h"
#include "tests/malloc/counter.h"
#include "tests/support/tick_hand.h"

namespace underact::arm {
namespace {

/// Keeps a result, so that no compiler leaves out what made it.
double kept = 0.0;

}  // namespace

TEST(Kinematics, AllocatesFreesAndLocksNothing) {
  const Model& omni = *findModel("omni-thesis");
  const Geometry geometry = *omniGeometry(omni);
  const chain::Chain chain = findModel("puma-560")->chain;
  const chain::SphericalWristArm closed = chain::recognise(chain).value();
  const chain::Chain ur_chain = findModel("ur5e")->chain;
  const chain::ThreeParallelArm ur = chain::threeParallelArm(ur_chain).value();
  const JointLimits limits = limitsOf(omni);
  chain::NumericOptions options;
  options.restarts = 3;
  FollowerState state, place;
  test::Watch watch;
  for (int tick = 0; tick < 300; ++tick) {
    JointAngles q_rad = test::scriptedAngles(37 * tick);
    if (tick % 50 == 7) q_rad[4] = 0.0;      // wrist in line
    if (tick % 50 == 9) q_rad[2] = kPi / 2;  // stretched
    if (tick % 50 == 11) q_rad[1] = kNotANumber;
    const Pose X_WT = tipPose(geometry, q_rad);
    kept += arm::kinematics(geometry, q_rad).J(0, 0) + dexterity(geometry, q_rad).condition;
    kept += singularityDistances(geometry, q_rad).elbow_rad + linkFrames(omni, q_rad)[5](0, 3);
    kept += forceOf(geometry, q_rad, torqueOf(geometry, q_rad, Vec3(1, 2, 3))).f_T_W.x();
    kept += static_cast<double>(solveAll(geometry, limits, X_WT).count);
    state = follow(geometry, limits, state, X_WT).next;
    place = followPosition(geometry, place, X_WT.translation()).next;
    const Pose X_WP = chain::kinematics(chain, q_rad).X_WT;
    kept += static_cast<double>(chain::solveAll(closed, X_WP).exact);
    kept += chain::solveNumerically(chain, X_WP, q_rad, options).residual_m;
    kept += static_cast<double>(chain::solveAll(ur, chain::forward(ur_chain, q_rad)).count);
  }
  EXPECT_EQ(watch.allocations(), 0);
  EXPECT_EQ(watch.frees(), 0);
  EXPECT_EQ(watch.locks(), 0);
}

}  // namespace underact::arm
