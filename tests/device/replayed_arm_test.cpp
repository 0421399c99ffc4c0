#include "device/replayed_arm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/servo/host.h"
#include "device/simulated_arm.h"

namespace underact::device {
namespace {

/// An arm that stands still and keeps what is written to it; its clock is its own.
class StillArm final : public servo::DevicePort {
 public:
  struct Seen {
    std::int64_t reads = 0, cuts = 0;
    double last_N = 0.0;
    bool answers = true;
    std::uint32_t epoch = 0;
  };
  explicit StillArm(Seen& seen) : seen_(seen) {}
  bool read(arm::Sample& sample) noexcept override {
    sample.time_ns = ++seen_.reads * 1'000'000 + 77;
    sample.q_rad = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    sample.buttons = 2;
    sample.epoch = seen_.epoch;
    return seen_.answers;
  }
  void write(const safety::GatedForce& force) noexcept override { seen_.last_N = force.f_T_W().norm(); }
  void cut() noexcept override { ++seen_.cuts; }
  servo::DeviceInfo info() const override { return {"Still arm", false, true, 0.5}; }

 private:
  Seen& seen_;
};

/// Row n has joint 1 at n / 3000 rad, which no power of two divides, and joint 6 turning through half a turn at row 10.
std::shared_ptr<Recorded> recordingOf(std::int64_t rows, int rate_hz = 1000) {
  auto recorded = std::make_shared<Recorded>();
  recorded->name = "Sweep";
  recorded->rate_hz = rate_hz;
  for (std::int64_t row = 0; row < rows; ++row) {
    RecordedRow one;
    one.q_rad = {static_cast<double>(row) / 3000.0, 0.6, 0.6, 0.0, 0.0, 0.0};
    one.q_rad[5] = row < 10 ? 3.1 : -3.1;
    one.buttons = row % 2 == 0 ? 0U : 0x80000001U;
    recorded->rows.push_back(one);
  }
  return recorded;
}

struct ReplayRig {
  explicit ReplayRig(int rate_hz = 1000) : arm(std::make_unique<StillArm>(seen), rate_hz) {}
  arm::Sample read() {
    arm::Sample sample;
    EXPECT_TRUE(arm.read(sample));
    return sample;
  }
  arm::Sample read(int times) {
    for (int done = 1; done < times; ++done) read();
    return read();
  }
  StillArm::Seen seen;
  ReplayedArm arm;
};

safety::GatedForce pushing() {
  safety::GateState state;
  state.level = 1.0;
  safety::GateInput asked;
  asked.f_T_W = Vec3(0.3, 0.0, 0.0);
  asked.engage = true;
  return safety::gate({0.88}, state, asked, 0.001).force;
}

TEST(ReplayedArm, TakesTheRatesOfTheArmBehindItButNotDuringAReplay) {
  ReplayRig still;
  EXPECT_NE(still.arm.fixedRateReason(), "") << "that arm has one alone";
  SimulatedArm::Options options;
  options.arm = *arm::findPreset(arm::kDefaultArm);
  options.model = *sim::findArmModel("ideal");
  ReplayedArm arm(std::make_unique<SimulatedArm>(options), 1000);
  EXPECT_EQ(arm.fixedRateReason(), "");
  arm::Sample sample;
  arm.read(sample);
  arm.setRate(4000);
  arm.read(sample);
  EXPECT_EQ(sample.time_ns, 1'250'000);
  const auto recorded = recordingOf(40, 1000);
  arm.replay(recorded);
  EXPECT_NE(arm.fixedRateReason().find("replayed"), std::string::npos);
  arm.play();
  for (int read = 0; read < 5; ++read) arm.read(sample);
  EXPECT_EQ(sample.q_rad[0], recorded->rows[1].q_rad[0]) << "a row of 1000 Hz is four ticks of 4000";
  EXPECT_EQ(sample.time_ns, 1'250'000 + 5 * 250'000);
  arm.replay(nullptr);
  arm.read(sample);
  EXPECT_EQ(sample.time_ns, 1'250'000 + 6 * 250'000);
  EXPECT_EQ(arm.fixedRateReason(), "");
}

TEST(ReplayedArm, HandsEverythingThroughWhileNothingIsReplayed) {
  ReplayRig rig;
  const arm::Sample sample = rig.read(3);
  EXPECT_EQ(sample.time_ns, 3'000'077);
  EXPECT_EQ(sample.q_rad, (arm::JointAngles{0.1, 0.2, 0.3, 0.4, 0.5, 0.6}));
  EXPECT_EQ(sample.buttons, 2U);
  EXPECT_EQ(sample.epoch, 0U);
  rig.arm.write(pushing());
  EXPECT_NEAR(rig.seen.last_N, 0.3, 1e-12);
  rig.arm.cut();
  EXPECT_EQ(rig.seen.cuts, 1);
  EXPECT_EQ(rig.arm.info().title, "Still arm");
  EXPECT_EQ(rig.arm.info().frozen_s, 0.5);
  rig.seen.epoch = 1;
  EXPECT_EQ(rig.read().epoch, 1U);
  rig.seen.answers = false;
  arm::Sample none;
  EXPECT_FALSE(rig.arm.read(none));
}

TEST(ReplayedArm, AtSpeedOneTheSamplesAreTheRecordedOnesToTheBitRowByRow) {
  ReplayRig rig;
  const auto recorded = recordingOf(500);
  rig.read(5);
  rig.arm.replay(recorded);
  arm::Sample sample = rig.read();
  EXPECT_EQ(sample.q_rad, recorded->rows[0].q_rad) << "paused at its beginning";
  EXPECT_EQ(sample.epoch, 1U);
  rig.arm.play();
  for (std::size_t row = 1; row < recorded->rows.size(); ++row) {
    const std::int64_t before_ns = sample.time_ns;
    sample = rig.read();
    ASSERT_EQ(sample.q_rad, recorded->rows[row].q_rad) << row;
    ASSERT_EQ(sample.buttons, recorded->rows[row].buttons) << row;
    ASSERT_EQ(sample.time_ns - before_ns, 1'000'000) << row;
    ASSERT_EQ(sample.epoch, 1U) << row;
  }
  EXPECT_TRUE(rig.arm.isPlaying());
  EXPECT_EQ(rig.read().q_rad, recorded->rows.back().q_rad);
  EXPECT_FALSE(rig.arm.isPlaying()) << "at its end";
  EXPECT_EQ(rig.seen.reads, 506) << "the other arm is read all the while";
}

TEST(ReplayedArm, ForcesGoNowhereAndItSaysWhatItIs) {
  ReplayRig rig;
  rig.read();
  rig.arm.write(pushing());
  rig.arm.replay(recordingOf(10));
  EXPECT_EQ(rig.arm.info().title, "Recorded arm: Sweep");
  EXPECT_TRUE(rig.arm.info().simulated);
  EXPECT_EQ(rig.arm.info().frozen_s, 0.0) << "a paused recording stands still to the bit";
  rig.read();
  rig.arm.write(pushing());
  EXPECT_EQ(rig.seen.last_N, 0.0);
  rig.arm.replay(nullptr);
  EXPECT_EQ(rig.arm.info().title, "Still arm");
  rig.read();
  rig.arm.write(pushing());
  EXPECT_NEAR(rig.seen.last_N, 0.3, 1e-12);
}

TEST(ReplayedArm, TheClockNeverRunsBackAndEachJumpIsAnEpoch) {
  ReplayRig rig;
  std::int64_t last_ns = rig.read(50).time_ns;
  std::uint32_t epoch = 0;
  const auto after = [&](std::uint32_t jumps, const char* what) {
    const arm::Sample sample = rig.read();
    EXPECT_GT(sample.time_ns, last_ns) << what;
    EXPECT_EQ(sample.epoch, epoch + jumps) << what;
    last_ns = sample.time_ns;
    epoch = sample.epoch;
    return sample;
  };
  rig.arm.replay(recordingOf(400));
  after(1, "beginning");
  rig.arm.play();
  after(0, "play");
  rig.arm.seek(300);
  EXPECT_EQ(after(1, "scrub").q_rad[0], 300.0 / 3000.0);
  rig.arm.setLoop({{297, 302}});
  after(0, "a loop is set");
  after(0, "its end");
  EXPECT_EQ(after(1, "wrap").q_rad[0], 297.0 / 3000.0);
  rig.arm.pause();
  EXPECT_EQ(after(0, "pause").q_rad[0], 297.0 / 3000.0);
  EXPECT_EQ(after(0, "paused").q_rad[0], 297.0 / 3000.0);
  rig.arm.seek(298);
  EXPECT_EQ(after(0, "one row further is no jump").q_rad[0], 298.0 / 3000.0);
  rig.arm.seek(297);
  EXPECT_EQ(after(1, "one row back").q_rad[0], 297.0 / 3000.0);
  rig.seen.answers = false;
  EXPECT_EQ(after(0, "an arm that was unplugged keeps no recording").q_rad[0], 297.0 / 3000.0);
  rig.seen.answers = true;
  rig.seen.reads = 0;  // its clock began anew
  rig.arm.replay(nullptr);
  EXPECT_EQ(after(1, "the arm is back").q_rad[0], 0.1);
  EXPECT_EQ(after(0, "and stays").q_rad[0], 0.1);
}

TEST(ReplayedArm, WhatIsSaidBetweenTwoReadsIsAllHeeded) {
  ReplayRig rig;
  rig.arm.replay(recordingOf(400));
  rig.arm.setSpeed(2.0);
  rig.arm.seek(100);
  rig.arm.play();
  EXPECT_EQ(rig.read().q_rad[0], 100.0 / 3000.0);
  EXPECT_EQ(rig.read().q_rad[0], 102.0 / 3000.0);
  rig.arm.play();
  rig.arm.seek(390);
  rig.read();
  EXPECT_TRUE(rig.arm.isPlaying());
  rig.read(6);
  EXPECT_FALSE(rig.arm.isPlaying());
  rig.arm.seek(10);
  EXPECT_EQ(rig.read(3).q_rad[0], 10.0 / 3000.0) << "it had come to its end: a scrub does not start it";
  rig.arm.seek(399);
  rig.read();
  rig.arm.play();
  EXPECT_EQ(rig.read().q_rad[0], 0.0) << "at the end, play begins anew";
}

TEST(ReplayedArm, OtherSpeedsLieOnTheLineBetweenRowsAndTurnTheShortWay) {
  ReplayRig rig;
  rig.arm.replay(recordingOf(100));
  rig.read();
  rig.arm.setSpeed(0.25);
  rig.arm.play();
  for (int quarter = 1; quarter <= 20; ++quarter)
    EXPECT_NEAR(rig.read().q_rad[0], 0.25 * quarter / 3000.0, 1e-15) << quarter;
  rig.read(4 * 4);
  EXPECT_EQ(rig.arm.row(), 9.0);
  const double step_rad = 2.0 * kPi - 6.2;
  EXPECT_NEAR(rig.read().q_rad[5], 3.1 + 0.25 * step_rad, 1e-12);
  EXPECT_NEAR(rig.read().q_rad[5], 3.1 + 0.5 * step_rad, 1e-12);
  rig.arm.setSpeed(1.0);
  EXPECT_EQ(rig.read().q_rad[0], 10.0 / 3000.0) << "on a row again";
  rig.arm.setSpeed(4.0);
  EXPECT_EQ(rig.read().q_rad[0], 14.0 / 3000.0);
  rig.arm.setSpeed(1e9);
  EXPECT_EQ(rig.arm.speed(), 4.0);
  rig.arm.setSpeed(0.0);
  EXPECT_EQ(rig.arm.speed(), 0.1);
}

TEST(ReplayedArm, AnotherRateIsPlayedByTime) {
  ReplayRig rig(1000);
  const auto recorded = recordingOf(4001, 4000);
  rig.arm.replay(recorded);
  rig.read();
  rig.arm.play();
  EXPECT_EQ(rig.read(250).q_rad, recorded->rows[1000].q_rad);
  ReplayRig faster(4000);
  faster.arm.replay(recordingOf(1001));
  faster.read();
  faster.arm.play();
  EXPECT_NEAR(faster.read(4 * 100).q_rad[0], 100.0 / 3000.0, 1e-12);
}

TEST(ReplayedArm, WhereNothingLeadsItJumpsInsteadOfTurningThere) {
  ReplayRig rig;
  const auto recorded = recordingOf(100);
  recorded->rows[5].begins_anew = true;
  rig.arm.replay(recorded);
  rig.read();
  rig.arm.setSpeed(0.5);
  rig.arm.play();
  arm::Sample sample = rig.read(9);
  EXPECT_EQ(rig.arm.row(), 4.5);
  EXPECT_EQ(sample.q_rad, recorded->rows[4].q_rad);
  const std::uint32_t epoch = sample.epoch;
  sample = rig.read();
  EXPECT_EQ(sample.q_rad, recorded->rows[5].q_rad);
  EXPECT_EQ(sample.epoch, epoch + 1);
}

TEST(ReplayedArm, EachSampleSaysWhereItCameFrom) {
  ReplayRig rig;
  rig.read(3);
  rig.arm.replay(recordingOf(100));
  const std::int64_t first_ns = rig.read().time_ns;
  rig.arm.play();
  rig.read(2);
  rig.arm.pause();
  rig.read();
  ReplayedArm::SampleOrigin place;
  for (const auto& [row, moves] : {std::pair{0.0, true}, {1.0, true}, {2.0, true}, {2.0, false}}) {
    ASSERT_TRUE(rig.arm.take(place));
    EXPECT_EQ(place.row, row);
    EXPECT_EQ(place.moves, moves);
  }
  EXPECT_EQ(place.time_ns, first_ns + 3'000'000);
  EXPECT_FALSE(rig.arm.take(place));
}

TEST(ReplayedArm, JumpsAcrossTheWorkspaceAreNoFaultToTheServo) {
  SimulatedArm::Options options;
  options.arm = *arm::findPreset("touch-measured");
  options.model = *sim::findArmModel("ideal");
  auto made = std::make_unique<ReplayedArm>(std::make_unique<SimulatedArm>(options), 1000);
  ReplayedArm* const arm = made.get();
  servo::Host host(std::move(made), {.clock = servo::Clock::Manual});
  scene::Description scene;
  scene.title = "Ball";
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 50.0}, target::Side::Both, {}, {}});
  ASSERT_TRUE(host.load(scene).empty());
  host.start();
  host.run(800);
  ASSERT_EQ(host.snapshot().mode, servo::Mode::Running);
  // A tenth of a radian a tick is some 20 m/s: where it is no jump it is a fault.
  auto recorded = recordingOf(60);
  for (std::size_t row = 30; row < 60; ++row) recorded->rows[row].q_rad[0] += 0.9;
  recorded->rows[30].begins_anew = true;
  arm->replay(recorded);
  const auto runs = [&](const char* what) {
    host.run(20);
    EXPECT_EQ(host.snapshot().mode, servo::Mode::Running) << what;
    EXPECT_EQ(host.snapshot().report.fault.kind, FaultKind::None) << what;
  };
  runs("beginning");
  arm->play();
  runs("play");
  runs("a gap in the recording");
  arm->seek(2);
  runs("scrub");
  arm->setLoop({{20, 40}});
  runs("loop");
  runs("loop");
  arm->replay(nullptr);
  runs("the arm is back");
  host.run(800);
  EXPECT_GT(host.snapshot().report.force.f_T_W().norm(), 0.0);
  recorded = recordingOf(60);
  recorded->rows[30].q_rad[0] += 0.9;
  arm->replay(recorded);
  arm->play();
  host.run(60);
  EXPECT_EQ(host.snapshot().report.fault.kind, FaultKind::TooFast) << "else the jumps above prove nothing";
}

}  // namespace
}  // namespace underact::device
