// A simulated arm that becomes another one while it runs, and a hand that lets go.
#include <gtest/gtest.h>

#include <memory>

#include "core/servo/host.h"
#include "device/measure_simulated.h"
#include "device/simulated_arm.h"

namespace underact::device {
namespace {

sim::ArmModel heavy() {
  sim::ArmModel model;
  model.mass_kg = 0.2;
  model.friction_N = 0.1;
  model.damping_N_s_per_m = 1.0;
  model.counts_per_turn = arm::EncoderCounts{20000.0, 0.0, 12000.0, 0.0, 0.0, 6000.0};
  return model;
}

SimulatedArm::Options modelOptions(const sim::ArmModel& model) {
  SimulatedArm::Options options;
  options.arm = *arm::findPreset(arm::kDefaultArm);
  options.model = model;
  return options;
}

scene::Description pointScene() {
  scene::Description scene;
  scene.title = "Point";
  scene.constraints.push_back({"point", scene::Point{Vec3(5.0, 5.0, 65.0)}, target::Side::Both, {}, {}});
  return scene;
}

/// Where a servo with a point brings the arm after so many ticks.
std::vector<arm::JointAngles> pathOf(std::unique_ptr<SimulatedArm> arm, int ticks) {
  servo::Host host(std::move(arm), {.clock = servo::Clock::Manual});
  EXPECT_TRUE(host.load(pointScene()).empty());
  host.start();
  host.run(ticks);
  std::vector<arm::JointAngles> path;
  host.drain([&](const servo::TickRecord& record) { path.push_back(record.q_rad); });
  return path;
}

TEST(SimulatedArm, ThatBecomesAModelMovesToTheBitAsOneMadeOfIt) {
  const sim::ArmModel& vendors = *sim::findArmModel(sim::kDefaultArmModel);
  auto other = std::make_unique<SimulatedArm>(modelOptions(vendors));
  other->become(heavy());
  const std::vector<arm::JointAngles> as_made = pathOf(std::make_unique<SimulatedArm>(modelOptions(heavy())), 1500);
  EXPECT_EQ(pathOf(std::move(other), 1500), as_made);
  EXPECT_NE(pathOf(std::make_unique<SimulatedArm>(modelOptions(vendors)), 1500), as_made);
}

TEST(SimulatedArm, ThatBecomesTheVendorsAgainHasItsPresetsEncoders) {
  const sim::ArmModel& vendors = *sim::findArmModel(sim::kDefaultArmModel);
  auto other = std::make_unique<SimulatedArm>(modelOptions(vendors));
  other->become(heavy());
  other->become(vendors);
  EXPECT_EQ(pathOf(std::move(other), 1500), pathOf(std::make_unique<SimulatedArm>(modelOptions(vendors)), 1500));
}

TEST(SimulatedArm, AHandThatLetsGoMovesNothingUntilItHoldsAgain) {
  SimulatedArm arm(modelOptions(*sim::findArmModel(sim::kDefaultArmModel)));
  arm::Sample sample;
  ASSERT_TRUE(arm.read(sample));
  const arm::JointAngles before = sample.q_rad;
  arm.holdStylus(false);
  sim::HandSetpoint setpoint;
  setpoint.p_WT = Vec3(0.02, 0.02, 0.04);
  arm.setSetpoint(setpoint);
  for (int tick = 0; tick < 500; ++tick) ASSERT_TRUE(arm.read(sample));
  EXPECT_EQ(sample.q_rad, before);
  arm.holdStylus(true);
  for (int tick = 0; tick < 500; ++tick) ASSERT_TRUE(arm.read(sample));
  EXPECT_NE(sample.q_rad, before);
}

TEST(MeasureSimulated, TellsItsProgressAndCanBeEnded) {
  double last = -1.0;
  const auto ended = measureSimulated(modelOptions(heavy()), {}, 1, [&last](double share) {
    EXPECT_GE(share, last);
    last = share;
    return share < 0.3;
  });
  ASSERT_FALSE(static_cast<bool>(ended));
  EXPECT_NEAR(last, 0.3, 0.01);
}

}  // namespace
}  // namespace underact::device
