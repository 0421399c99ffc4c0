#include "device/touch_reference_points.h"

#include <gtest/gtest.h>

#include "core/registration/sheet.h"
#include "device/simulated_arm.h"

namespace underact::device {
namespace {

/// The arm stands before the person, turned by a third of a right angle to the left.
Pose truePose() {
  Pose X_DW = Pose::Identity();
  X_DW.linear() = Eigen::AngleAxisd(0.5, Vec3::UnitY()).toRotationMatrix();
  X_DW.translation() = Vec3(0.06, 0.05, -0.03);
  return X_DW;
}

/// A hand that goes to the mark it is asked for, waits, and presses; again where it is told that it moved.
struct Hand {
  SimulatedArm& arm;
  std::vector<Vec3> points_D;
  std::vector<std::string> heard;
  int looks = 0;

  void hear(const std::string& sentence) {
    heard.push_back(sentence);
    looks = 0;
    const std::size_t at = sentence.find("reference point ");
    if (at == std::string::npos) return;
    const Vec3& mark_D = points_D.at(std::stoul(sentence.substr(at + 16)) - 1);
    arm.setSetpoint({truePose().inverse() * mark_D, Vec3::Zero(), Mat3::Identity(), false});
  }
  bool look() {
    ++looks;  // some 20 ms each
    arm.holdButton(looks > 60 && looks < 65);
    return looks < 2000;
  }
};

SimulatedArm::Options easyArm() {
  SimulatedArm::Options options;
  options.arm = *arm::findPreset(arm::kDefaultArm);
  options.model.friction_N = 0.0;  // the hand gets where it wants
  options.model.encoders = false;
  options.start_p_WT = Vec3(0.0, -0.05, 0.0);
  return options;
}

TEST(TouchMarks, ASimulatedArmIsRegisteredWhereItStands) {
  auto arm = std::make_unique<SimulatedArm>(easyArm());
  Hand hand{*arm, registration::sheetPoints(), {}, 0};
  const auto touches = touchReferencePoints(
      std::move(arm), *arm::findPreset(arm::kDefaultArm), 1000, hand.points_D,
      {[&](const std::string& sentence) { hand.hear(sentence); }, [&] { return hand.look(); }, 60.0});
  ASSERT_TRUE(touches) << touches.problems().front().sentence;
  ASSERT_EQ(touches.value().size(), 3U);
  const registration::Fit fit = registration::fitTouches(touches.value()).value();
  EXPECT_LT((fit.X_DW.translation() - truePose().translation()).norm(), 1e-3);
  EXPECT_LT((fit.X_DW.linear() - truePose().linear()).norm(), 0.02);
  EXPECT_EQ(hand.heard.back(), "All reference points have been touched.");
}

TEST(TouchMarks, NobodyAtTheArmAndAnEndAreSaid) {
  const arm::Preset& preset = *arm::findPreset(arm::kDefaultArm);
  const auto quiet = [](const std::string&) {};
  const auto nobody = touchReferencePoints(std::make_unique<SimulatedArm>(easyArm()), preset, 1000,
                                           registration::sheetPoints(), {quiet, [] { return true; }, 0.1});
  ASSERT_FALSE(nobody);
  EXPECT_NE(nobody.problems().front().sentence.find("Nobody pressed the stylus button at reference point 1"),
            std::string::npos);
  const auto ended = touchReferencePoints(std::make_unique<SimulatedArm>(easyArm()), preset, 1000,
                                          registration::sheetPoints(), {quiet, [] { return false; }, 10.0});
  ASSERT_FALSE(ended);
  EXPECT_NE(ended.problems().front().sentence.find("ended"), std::string::npos);
}

}  // namespace
}  // namespace underact::device
