#include "core/arm/forward.h"

#include "core/arm/sample.h"
#include "tests/core/arm/golden.h"
#include "tests/core/arm/thesis.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

// 0.0001 nm: what the vectors ask of a double. Coordinates are below 0.5 m, whose rounding is 5.6e-17 m, and each is a
// sum of three products.
constexpr double kGolden_m = 1e-13;
// Entries of a rotation: products of up to five factors, each within 1 ulp.
constexpr double kRotation = 2e-15;

const Preset& touch() {
  return *findPreset("touch-measured");
}

Mat3 about(const Vec3& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

TEST(Forward, MeetsTheGoldenPoses) {
  const test::Value file = test::golden("fk.json");
  const test::Value* const cases = file.find("cases");
  ASSERT_NE(cases, nullptr);
  ASSERT_EQ(cases->items.size(), 200U);
  for (const test::Value& one : cases->items) {
    const JointAngles q_rad = test::anglesOf(*one.find("q"));
    const Pose expected = test::poseOf(*one.find("T")), X_WT = tipPose(thesis().geometry, q_rad);
    ASSERT_LE((X_WT.translation() - expected.translation()).cwiseAbs().maxCoeff(), kGolden_m) << "line " << one.line;
    ASSERT_LE((X_WT.linear() - expected.linear()).cwiseAbs().maxCoeff(), kRotation) << "line " << one.line;
    ASSERT_EQ(tipPosition(thesis().geometry, q_rad), X_WT.translation());
  }
}

TEST(Forward, MeetsTheRecordedPoseOfATouch) {
  const JointAngles q_rad = dhFromDevice({0.0, 0.26889, -0.370813, 0.000108409, 0.797273, -1.94046});
  const Vec3 p_WT = tipPosition(touch().geometry, q_rad);
  // The record is rounded to 0.1 um, and thigh and shin, at 0.13335 m, to 1e-6 rad.
  const double rounding_m = 0.5e-7 + 2 * 0.5e-6 * 0.13335;
  EXPECT_LE((p_WT - Vec3(0.0, -65.5107e-3, -88.1142e-3)).cwiseAbs().maxCoeff(), rounding_m);
}

TEST(Forward, MeetsTheFormulasOfATouch) {  // oracle: the device's own formulas, in its own angles; no DH table
  underact::test::Random random(underact::test::Seed{1});
  for (int draw = 0; draw < underact::test::sweep(500, 50000); ++draw) {
    JointAngles device{};
    for (double& angle_rad : device) angle_rad = random.between(-kPi, kPi);
    const auto& [q1, q2, q3, g1, g2, g3, none7, none8] = device;
    const double r = 0.13335 * std::cos(q2) + 0.13335 * std::sin(q3);
    const Vec3 p_WT(-std::sin(q1) * r, 0.13335 * std::sin(q2) - 0.13335 * std::cos(q3) + 0.02335,
                    std::cos(q1) * r - 0.16835);
    const Mat3 R_WT = about(Vec3::UnitY(), -q1) * about(Vec3::UnitX(), -q3) * about(Vec3::UnitY(), g1) *
                      about(Vec3::UnitX(), -g2) * about(Vec3::UnitZ(), -g3);
    const Pose X_WT = tipPose(touch().geometry, dhFromDevice(device));
    ASSERT_LE((X_WT.translation() - p_WT).cwiseAbs().maxCoeff(), kGolden_m);
    ASSERT_LE((X_WT.linear() - R_WT).cwiseAbs().maxCoeff(), kRotation);
  }
}

TEST(Forward, SkeletonHasTheLengthsOfTheArm) {
  underact::test::Random random(underact::test::Seed{2});
  for (const Preset& preset : presets()) {
    for (int draw = 0; draw < 100; ++draw) {
      JointAngles q_rad{};
      for (double& angle_rad : q_rad) angle_rad = random.between(-kPi, kPi);
      const Skeleton bones = skeleton(preset.geometry, q_rad);
      ASSERT_NEAR((bones.p_WElbow - bones.p_WShoulder).norm(), preset.geometry.upper_m, kGolden_m);
      ASSERT_NEAR((bones.p_WTip - bones.p_WElbow).norm(), preset.geometry.fore_m, kGolden_m);
      ASSERT_EQ(bones.p_WTip, tipPosition(preset.geometry, q_rad));
    }
  }
}

TEST(Forward, ForearmAndWorkspaceAreTheFramesOfTheTable) {
  EXPECT_EQ(workspaceFromBase() * Vec3::UnitX(), Vec3::UnitZ());  // eq. 3.1: z_W = x_B
  EXPECT_EQ(workspaceFromBase() * Vec3::UnitY(), Vec3::UnitX());
  // With joints 4 to 6 at zero the tip's frame is the forearm's.
  const JointAngles q_rad{0.3, 0.7, -0.2, 0.0, 0.0, 0.0};
  const Mat3 R_W3 = workspaceFromBase() * baseFromForearm(q_rad);
  EXPECT_LE((tipPose(thesis().geometry, q_rad).linear() - R_W3).cwiseAbs().maxCoeff(), kRotation);
}

TEST(Forward, IsNotFiniteForANaN) {
  EXPECT_FALSE(tipPosition(thesis().geometry, {kNotANumber, 0, 0, 0, 0, 0}).allFinite());
  EXPECT_FALSE(tipPosition(thesis().geometry, {0, kInfinity, 0, 0, 0, 0}).allFinite());
}

}  // namespace
}  // namespace underact::arm
