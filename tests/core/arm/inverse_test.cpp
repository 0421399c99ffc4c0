#include "core/arm/inverse.h"

#include <algorithm>
#include <string>

#include "core/arm/forward.h"
#include "tests/core/arm/golden.h"
#include "tests/core/arm/thesis.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

// Of regular poses: what the vectors ask, to be divided by what the pose loses (see conditionOf()).
constexpr double kGolden_rad = 1e-8;
// A tip found again. At full stretch the elbow's angle is a square root of the rounding, 1e-8 rad, but the tip moves
// with its square; what stays is the rounding of coordinates of 0.3 m through a dozen operations.
constexpr double kTip_m = 2e-15;

/// The closed form divides by these: sine of joint 5, cosine of joint 3, and the distance from axis 1 in arm's lengths.
double conditionOf(const JointAngles& q_rad, const Vec3& p_WT) {
  const Vec3 p_BT_W = p_WT - thesis().geometry.p_WB;
  return std::abs(std::sin(q_rad[4])) * std::abs(std::cos(q_rad[2])) *
         (std::hypot(p_BT_W.x(), p_BT_W.z()) / (thesis().geometry.upper_m + thesis().geometry.fore_m));
}

double furthest(const JointAngles& a_rad, const JointAngles& b_rad) {  // modulo a turn
  double furthest_rad = 0.0;
  for (std::size_t joint = 0; joint < 6; ++joint) {
    furthest_rad = std::max(furthest_rad, std::abs(std::remainder(a_rad[joint] - b_rad[joint], 2.0 * kPi)));
  }
  return furthest_rad;
}

JointAngles jointsAt(const Geometry& geometry, const Pose& X_WT) {
  return solveWrist(solvePosition(geometry, X_WT.translation()).q_rad, X_WT.linear());
}

TEST(Inverse, MeetsTheGoldenSolutions) {
  const test::Value file = test::golden("ik.json");
  int regular = 0;
  for (const test::Value& one : file.find("cases")->items) {
    if (one.find("status")->text != "regular") continue;
    ++regular;
    const Pose X_WT = test::poseOf(*one.find("T"));
    EXPECT_TRUE(solvePosition(thesis().geometry, X_WT.translation()).reachable);
    const JointAngles q_rad = jointsAt(thesis().geometry, X_WT);
    double nearest_rad = kInfinity;
    for (const test::Value& solution : one.find("solutions")->items) {
      nearest_rad = std::min(nearest_rad, furthest(q_rad, test::anglesOf(*solution.find("q"))));
    }
    EXPECT_LE(nearest_rad, kGolden_rad / conditionOf(q_rad, X_WT.translation())) << "line " << one.line;
    EXPECT_LE(nearest_rad, 1e-9) << "line " << one.line;  // no regular case of the file is worse than 1 in 1000
  }
  EXPECT_EQ(regular, 65);
}

TEST(Inverse, SingularPosesAreReachedAllTheSame) {
  const test::Value file = test::golden("ik.json");
  int singular = 0;
  for (const test::Value& one : file.find("cases")->items) {
    const std::string& status = one.find("status")->text;
    if (status == "regular" || status == "unreachable") continue;
    ++singular;
    const Pose X_WT = test::poseOf(*one.find("T"));
    const Pose found = tipPose(thesis().geometry, jointsAt(thesis().geometry, X_WT));
    EXPECT_LE((found.translation() - X_WT.translation()).norm(), kTip_m) << status << ", line " << one.line;
    // solveWrist() calls joint 5 zero below 1e-9, and so may miss the direction by as much.
    EXPECT_LE((found.linear() - X_WT.linear()).cwiseAbs().maxCoeff(), 2e-9) << status << ", line " << one.line;
  }
  EXPECT_EQ(singular, 28);
}

TEST(Inverse, OutOfReachItGoesAsNearAsTheArmCan) {
  const test::Value file = test::golden("ik.json");
  const Geometry& geometry = thesis().geometry;
  int unreachable = 0;
  for (const test::Value& one : file.find("cases")->items) {
    if (one.find("status")->text != "unreachable") continue;
    ++unreachable;
    const Vec3 p_WT = test::poseOf(*one.find("T")).translation();
    const PositionSolution found = solvePosition(geometry, p_WT);
    EXPECT_FALSE(found.reachable) << "line " << one.line;
    const Vec3 p_BT_W = tipPosition(geometry, found.q_rad) - geometry.p_WB, asked_W = p_WT - geometry.p_WB;
    const bool too_far = asked_W.norm() > geometry.upper_m + geometry.fore_m;
    EXPECT_NEAR(p_BT_W.norm(), too_far ? geometry.upper_m + geometry.fore_m : geometry.fore_m - geometry.upper_m,
                kTip_m);
    if (asked_W.norm() < 1e-6) continue;  // at the shoulder no direction is asked for
    EXPECT_NEAR(p_BT_W.normalized().dot(asked_W.normalized()), 1.0, 1e-15);
  }
  EXPECT_EQ(unreachable, 7);
}

TEST(Inverse, JointsInsideTheLimitsAreFoundAgain) {
  underact::test::Random random(underact::test::Seed{4});
  int tried = 0;
  for (const Preset& preset : presets()) {
    for (int draw = 0; draw < underact::test::sweep(1000, 100000); ++draw) {
      JointAngles q_rad{};
      for (std::size_t joint = 0; joint < 6; ++joint) {
        q_rad[joint] = random.between(preset.limits.min_rad[joint], preset.limits.max_rad[joint]);
      }
      const Pose X_WT = tipPose(preset.geometry, q_rad);
      // Thigh and shin at their ends together bring the tip behind axis 1, which is another branch.
      const double reach_m =
          preset.geometry.upper_m * std::cos(q_rad[1]) + preset.geometry.fore_m * std::sin(q_rad[1] + q_rad[2]);
      if (reach_m < 1e-3) continue;
      ++tried;
      const PositionSolution found = solvePosition(preset.geometry, X_WT.translation());
      ASSERT_TRUE(found.reachable);
      // Rounding (3e-16) over cos q3 >= 0.199, sin q5 >= 0.51 and 1 mm in 277 off axis 1, times a dozen operations.
      ASSERT_LE(furthest(solveWrist(found.q_rad, X_WT.linear()), q_rad), 1e-11);
    }
  }
  EXPECT_GT(tried, 1900);
}

TEST(Inverse, LimitsHoldEachJointAndTheSizeOfJointFive) {
  const JointLimits& limits = thesis().limits;
  EXPECT_EQ(withinLimits(limits, {-9, -9, -9, -9, -9, -9}), (JointAngles{-0.98, 0.0, -0.81, -2.54, -2.60, -2.34}));
  EXPECT_EQ(withinLimits(limits, {9, 9, 9, 9, 9, 9}), (JointAngles{0.98, 1.75, 1.37, 2.60, 2.60, 2.34}));
  EXPECT_EQ(withinLimits(limits, {0, 0, 0, 0, -0.1, 0})[4], -0.62);
  const JointAngles inside{0.1, 0.2, 0.3, 0.4, -0.7, 0.5};
  EXPECT_EQ(withinLimits(limits, inside), inside);
}

TEST(Inverse, FarOffIsNoReasonForNotANumber) {
  for (const double far_m : {1e3, 1e150, 1e300}) {
    for (const double angle_rad : solvePosition(thesis().geometry, Vec3(far_m, -far_m, far_m)).q_rad) {
      EXPECT_TRUE(std::isfinite(angle_rad)) << far_m;
    }
  }
}

TEST(Inverse, TheWristFindsTheTurnAgainHoweverNearItIsToBeingInLine) {  // eq. 3.20 is 1e-7 rad off at 1e-9
  test::Random random(test::Seed{20070461});
  for (double off_rad = 1e-15; off_rad < 1e-2; off_rad *= 3.0) {
    for (const double q5_rad : {off_rad, kPi - off_rad}) {
      const JointAngles q_rad{0.2, 0.7, 0.3, random.between(-3.0, 3.0), q5_rad, random.between(-3.0, 3.0)};
      const Mat3 R_WT = tipPose(thesis().geometry, q_rad).linear();
      const JointAngles found = solveWrist(q_rad, R_WT);
      const Mat3 again = tipPose(thesis().geometry, found).linear();
      ASSERT_LE((again - R_WT).cwiseAbs().maxCoeff(), 2e-12) << off_rad;  // joint 4 is 0 below 1e-12
    }
  }
}

}  // namespace
}  // namespace underact::arm
