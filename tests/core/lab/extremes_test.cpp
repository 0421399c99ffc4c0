#include "core/lab/extremes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/arm/forward.h"
#include "core/base/units.h"
#include "core/scene/compile.h"
#include "core/scene/read.h"
#include "core/scene/scene_arm.h"

namespace underact::lab {
namespace {

/// A scene of one constraint, held by 0.5 N/mm; poses: of the arm, or of one with narrower limits.
SceneExtremes extremesWith(const std::string& constraint, const std::string& arm = "omni-thesis", int poses = 400,
                           const arm::JointLimits* limits = nullptr) {
  const Result<scene::Description> scene = scene::readScene(
      R"({"underact_scene": 1, "title": "Limits", "arm": ")" + arm +
          R"(", "control": {"law": "P", "kp_N_per_mm": 0.5}, "constraints": [{"name": "a", )" + constraint + "}]}",
      "limits.json");
  EXPECT_TRUE(scene);
  const Result<tick::TickProgram> program = scene::compile(scene.value());
  EXPECT_TRUE(program);
  arm::Preset preset = scene::armOf(scene.value());
  if (limits != nullptr) preset.limits = *limits;
  return extremesOf(program.value(), preset, 7, poses);
}

TEST(ExtremesOf, APointThatIsHeldAreItsSpring) {
  const SceneExtremes extremes = extremesWith(R"("type": "point", "position_mm": [10, 20, 30])");
  const Vec3 p_WP(0.01, 0.02, 0.03);
  EXPECT_DOUBLE_EQ(extremes.force_N.value, 500.0 * (extremes.force_N.p_WT - p_WP).norm());
  EXPECT_GT(extremes.force_N.value, 500.0 * 0.1) << "somewhere in the workspace it is 10 cm away";
  EXPECT_EQ(extremes.poses, 400);
  EXPECT_EQ(extremes.without_answer, 0);
  EXPECT_GT(extremes.beyond_limit, 390) << "0.88 N hold it for 1.8 mm";
  // A step of the turret, 0.055 mm on the average at the tip (the Omni's data sheet), times the spring: the greatest is
  // some times that, at the end of the arm.
  EXPECT_GT(extremes.per_encoder_step_N.value, 500.0 * 20e-6);
  EXPECT_LT(extremes.per_encoder_step_N.value, 500.0 * 300e-6);
  // An ulp of an angle of at most 4 rad moves the tip by its reach of 0.28 m times that; the rest is rounding of tip
  // and force, some ulp of a metre.
  EXPECT_LT(extremes.per_ulp_N.value, 500.0 * 8 * 0x1p-51);
  EXPECT_GT(extremes.tick.p50_ns, 0.0);
  EXPECT_LE(extremes.tick.p99_ns, extremes.tick.max_ns);
}

/// A constraint about the tip of the Omni with all joints at 0, the only pose within kOnePose: its centre, off the tip.
const arm::JointLimits kOnePose{};
std::string aboutTip(const std::string& shape, const Vec3& off_mm) {
  const Vec3 p_mm = kMillimetrePerMetre * arm::tipPosition(arm::findPreset("omni-thesis")->geometry, {}) + off_mm;
  std::ostringstream text;
  text << std::setprecision(17) << shape << R"(, "center_mm": [)" << p_mm.x() << ", " << p_mm.y() << ", " << p_mm.z()
       << "]";
  return text.str();
}

TEST(ExtremesOf, PosesAtTheMiddleOfASphereHaveNoAnswer) {
  const std::string sphere = aboutTip(R"("type": "sphere", "radius_mm": 50)", Vec3::Zero());
  EXPECT_EQ(extremesWith(sphere, "omni-thesis", 40, &kOnePose).without_answer, 40);
  EXPECT_EQ(extremesWith(sphere).without_answer, 0);
}

TEST(ExtremesOf, AJumpOfTheTargetIsFoundAsAChangeByAnEncoderStep) {
  // A micrometre beside the middle of a cube of 100 mm another face is nearest after a step, which is some 50 um.
  const std::string cube = aboutTip(R"("type": "box", "size_mm": [100, 100, 100])", Vec3(1e-3, 2e-3, 3e-3));
  const SceneExtremes extremes = extremesWith(cube, "omni-thesis", 1, &kOnePose);
  EXPECT_GT(extremes.per_encoder_step_N.value, 0.5 * 50.0 * std::sqrt(2.0) * 0.99) << "from one face to the next";
  EXPECT_LT(extremes.per_ulp_N.value, 1e-9);
}

TEST(ExtremesOf, AreTheSameEachTimeAndOthersForAnotherArm) {
  const std::string point = R"("type": "point", "position_mm": [300, 200, 300])";
  const SceneExtremes a = extremesWith(point, "ur5e", 50), b = extremesWith(point, "ur5e", 50);
  EXPECT_EQ(a.force_N.value, b.force_N.value);
  EXPECT_EQ(a.force_N.p_WT, b.force_N.p_WT);
  EXPECT_EQ(a.per_ulp_N.value, b.per_ulp_N.value);
  EXPECT_GT(a.force_N.p_WT.norm(), 0.4) << "it reaches farther than an Omni";
}

}  // namespace
}  // namespace underact::lab
