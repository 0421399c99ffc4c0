#include "core/identify/measurement.h"

#include <gtest/gtest.h>

namespace underact::identify {
namespace {

constexpr std::int64_t kTick_ns = 1'000'000;

/// A servo that does as it is told, one tick after the other.
struct Servo {
  Plan plan = makePlan({}).value();
  std::uint64_t revision = 0;
  std::int64_t time_ns = 0;
  std::vector<scene::Description> put;
  Measurement measurement{plan, [this](const scene::Description& scene) -> Result<std::uint64_t> {
                            put.push_back(scene);
                            return ++revision;
                          }};
  void tick(std::uint64_t of_revision, unsigned input = servo::kHadSample) {
    servo::TickRecord record;
    record.time_ns = time_ns += kTick_ns;
    record.revision = of_revision;
    record.input = input;
    measurement.add(record);
    EXPECT_TRUE(measurement.advance().empty());
  }
  void run(double seconds) {
    for (int left = static_cast<int>(1000.0 * seconds); left > 0; --left) tick(revision);
  }
};

TEST(Plan, TakesItsTimeAndNamesPlacesThatAreOutOfReach) {
  const Plan plan = makePlan({}).value();
  // 3 axes of 12 swings of 0.4 s, 2 s and 3 times 0.6 s to settle, 1.2 s of rest, 14 s of hand work.
  EXPECT_NEAR(plan.seconds(), 3 * 12 * 0.4 + 2.0 + 3 * 0.6 + 1.2 + 14.0, 1e-9);
  Wanted far;
  far.places_W = {{0.0, 0.0, 0.06}, {0.5, 0.0, 0.0}};
  const Result<Plan> refused = makePlan(far);
  ASSERT_FALSE(static_cast<bool>(refused));
  ASSERT_EQ(refused.problems().size(), 1U);
  EXPECT_NE(refused.problems()[0].sentence.find("(500, 0, 0)"), std::string::npos);
  Wanted unknown, nowhere;
  unknown.arm_of.arm = "no-such-arm";
  nowhere.places_W.clear();
  EXPECT_FALSE(makePlan(unknown));
  EXPECT_FALSE(makePlan(nowhere));
}

TEST(Plan, OnlyTheTargetMovesBetweenTheSwingsOfAnAxis) {
  const Plan plan = makePlan({}).value();
  for (std::size_t stage = 1; stage < plan.stages.size(); ++stage) {
    const Stage &before = plan.stages[stage - 1], &now = plan.stages[stage];
    if (now.kind != StageKind::Swing || before.kind != StageKind::Swing) continue;
    const Vec3 moved_mm = std::get<scene::Point>(now.scene.constraints[0].shape).position_mm -
                          std::get<scene::Point>(before.scene.constraints[0].shape).position_mm;
    EXPECT_EQ(moved_mm.cwiseAbs().sum(), std::abs(moved_mm[now.axis]));
    EXPECT_EQ(now.scene.control, before.scene.control);
    EXPECT_EQ(now.scene.control.gains.kp_N_per_mm[now.axis], kSwing_N_per_mm);
    EXPECT_EQ(now.scene.control.gains.kd_N_s_per_mm[now.axis], 0.0);
  }
}

TEST(Measurement, AsksFirstAndCountsFromTheTickInWhichTheSceneIsThere) {
  Servo servo;
  EXPECT_EQ(servo.measurement.state(), Measurement::State::Asks);
  servo.run(5.0);
  EXPECT_EQ(servo.measurement.share(), 0.0);
  ASSERT_TRUE(servo.measurement.go().empty());
  for (int tick = 0; tick < 100; ++tick) servo.tick(0);  // still the scene before
  EXPECT_EQ(servo.measurement.stageSeconds(), 0.0);
  servo.tick(1);
  servo.tick(1);
  EXPECT_NEAR(servo.measurement.stageSeconds(), 1e-3, 1e-12);
}

TEST(Measurement, GoesThroughAllStagesAndAsksForTheHandTwiceMore) {
  Servo servo;
  int asked = 0;
  for (int tick = 0; tick < 60'000 && servo.measurement.state() != Measurement::State::Done; ++tick) {
    if (servo.measurement.state() == Measurement::State::Asks) {
      ++asked;
      ASSERT_TRUE(servo.measurement.go().empty());
    }
    servo.tick(servo.revision);
  }
  EXPECT_EQ(servo.measurement.state(), Measurement::State::Done);
  EXPECT_EQ(asked, 3);  // let go, press, turn
  EXPECT_EQ(servo.measurement.share(), 1.0);
  EXPECT_EQ(servo.put.size(), servo.plan.stages.size());
  std::size_t kept = 0;
  for (const Stage& stage : servo.plan.stages) kept += stage.kind != StageKind::Settle ? 1 : 0;
  ASSERT_EQ(servo.measurement.recorded().size(), kept);
  for (const Recorded& one : servo.measurement.recorded()) {
    const Stage& stage = servo.plan.stages[one.stage];
    EXPECT_NE(stage.kind, StageKind::Settle);
    EXPECT_NEAR(static_cast<double>(one.rows.size()), 1000.0 * stage.seconds, 2.0);
  }
}

TEST(Measurement, AfterAFaultTheAxisBeginsAnewAndTheOnesBeforeItAreKept) {
  Servo servo;
  ASSERT_TRUE(servo.measurement.go().empty());
  servo.run(2.0 + 12 * 0.4 + 0.6 + 2.0);  // x whole, y half
  EXPECT_EQ(servo.measurement.stage().axis, 1);
  const double share = servo.measurement.share();
  servo.measurement.interrupt("It broke.");
  EXPECT_EQ(servo.measurement.state(), Measurement::State::Stopped);
  EXPECT_EQ(servo.measurement.reason(), "It broke.");
  servo.run(3.0);
  EXPECT_NEAR(servo.measurement.share(), share, 1e-12);
  ASSERT_TRUE(servo.measurement.repeat().empty());
  EXPECT_EQ(servo.measurement.stage().kind, StageKind::Settle);
  EXPECT_EQ(servo.measurement.stage().axis, 1);
  EXPECT_TRUE(servo.measurement.reason().empty());
  for (const Recorded& one : servo.measurement.recorded()) EXPECT_EQ(servo.plan.stages[one.stage].axis, 0);
  EXPECT_EQ(servo.measurement.recorded().size(), 12U);
  EXPECT_LT(servo.measurement.share(), share);
  EXPECT_NEAR(servo.measurement.share(), (2.0 + 12 * 0.4) / servo.plan.seconds(), 0.01);
}

TEST(Measurement, AStopWhileItAsksIsTakenUpByAskingOrGoingOn) {
  Servo servo;
  servo.measurement.interrupt("Stopped.");
  EXPECT_EQ(servo.measurement.state(), Measurement::State::Stopped);
  ASSERT_TRUE(servo.measurement.repeat().empty());
  EXPECT_EQ(servo.measurement.state(), Measurement::State::Runs);
}

TEST(Measurement, ATickWithoutASampleIsAGap) {
  Servo servo;
  ASSERT_TRUE(servo.measurement.go().empty());
  servo.run(2.1);
  const std::size_t before = servo.measurement.recorded().back().rows.size();
  servo.tick(servo.revision, 0U);
  EXPECT_EQ(servo.measurement.recorded().back().rows.size(), before);
}

TEST(Measurement, ASceneThatIsRefusedIsAProblem) {
  Measurement measurement(makePlan({}).value(),
                          [](const scene::Description&) -> Result<std::uint64_t> { return Problems{{"No."}}; });
  EXPECT_EQ(measurement.go().front().sentence, "No.");
}

}  // namespace
}  // namespace underact::identify
