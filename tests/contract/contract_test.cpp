// What every driver of an arm has to keep, seen from the arm's side of it. A new driver: a FarSide for it and a row in
// drivers.cpp. No test here asks how fast a busy machine is: what must come is waited for, what must end is counted in
// forces that still came.
#include <gtest/gtest.h>

#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/preset.h"
#include "core/servo/host.h"
#include "tests/contract/far_side.h"
#include "tests/support/comes.h"
#include "tests/support/property.h"

namespace underact::test {
namespace {

using namespace std::chrono_literals;

/// The stylus is drawn along x, by some 0.5 N where the tip rests.
scene::Description pull() {
  scene::Description scene;
  scene.title = "Pull";
  scene.constraints.push_back({"point", scene::Point{Vec3(5.0, 0.0, 60.0)}, target::Side::Both, {}, {}});
  return scene;
}

class Contract : public testing::TestWithParam<Driver> {
 protected:
  void SetUp() override {
    std::string why;
    far = GetParam().make(why);
    if (!far) GTEST_SKIP() << why;
  }
  std::unique_ptr<servo::DevicePort> opened() {
    Result<std::unique_ptr<servo::DevicePort>> arm = far->open();
    EXPECT_TRUE(arm) << arm.problems().front().sentence;
    return std::move(arm).value();
  }
  /// A servo that pulls, and the force of that is at the motors.
  void pushOn() {
    host = std::make_unique<servo::Host>(opened(), servo::HostOptions{.max_late = 1'000'000});
    faults = 0;
    ASSERT_TRUE(host->load(pull()).empty());
    host->start();
    host->begin();
    ASSERT_TRUE(comes([this] { return sent_N().norm() > 0.2 && pushes(); })) << host->trouble();
  }
  /// What the servo wrote last. A busy machine that held it up may have brought it to a fault, which is not what is
  /// looked for: then it is started again.
  Vec3 sent_N() {
    const servo::Snapshot seen = host->snapshot();
    const FaultKind kind = seen.report.fault.kind;
    const bool is_of_the_machine = kind == FaultKind::NoSample || kind == FaultKind::StaleSample ||
                                   kind == FaultKind::TooLate || kind == FaultKind::StoodStill;
    if (seen.mode == servo::Mode::Faulted && (is_of_the_machine || faults++ < 5)) host->start();
    return seen.report.force.f_T_W();
  }
  bool pushes() const { return far->force_N().norm() > 0.1; }
  bool rests() const { return far->force_N().norm() == 0.0; }

  std::unique_ptr<FarSide> far;
  std::unique_ptr<servo::Host> host;
  int faults = 0;
};

TEST_P(Contract, TellsWhatItIs) {
  const std::unique_ptr<servo::DevicePort> arm = opened();
  EXPECT_FALSE(arm->info().title.empty());
  EXPECT_NE(arm->info().simulated, arm->info().untested) << "no driver here was tried on its hardware";
  EXPECT_EQ(arm->trouble(), "");
}

TEST_P(Contract, SamplesAreRadiansOfTheArmInTimeThatRises) {
  const std::unique_ptr<servo::DevicePort> arm = opened();
  const arm::Geometry& geometry = arm::findPreset(arm::kDefaultArm)->geometry;
  std::int64_t before_ns = -1;
  for (const Vec3& p_WT : {Vec3(0.0, 0.0, 0.06), Vec3(0.03, 0.02, 0.05), Vec3(-0.04, -0.01, 0.04)}) {
    far->placeTip(p_WT);
    arm::Sample sample;
    double off_m = 1.0;
    ASSERT_TRUE(comes([&] {
      if (!arm->read(sample)) return false;
      EXPECT_GT(sample.time_ns, before_ns);
      before_ns = sample.time_ns;
      off_m = (arm::tipPosition(geometry, sample.q_rad) - p_WT).norm();
      return off_m <= far->resolution_m();
    })) << "off by "
        << off_m << " m";
  }
}

TEST_P(Contract, TheButtonNearerToTheTipIsBitZero) {
  if (!far->hasButton()) GTEST_SKIP() << "this arm has no button";
  const std::unique_ptr<servo::DevicePort> arm = opened();
  for (const bool held : {true, false, true}) {
    far->holdButton(held);
    arm::Sample sample;
    EXPECT_TRUE(comes([&] { return arm->read(sample) && ((sample.buttons & 1U) != 0) == held; })) << held;
  }
}

TEST_P(Contract, AForceComesAsNewtonsInTheArmsFrame) {
  pushOn();
  ASSERT_TRUE(comes([this] {  // the soft start is over
    const Vec3 wanted_N = sent_N();
    return wanted_N.norm() > 0.4 && (far->force_N() - wanted_N).norm() <= far->forceResolution_N();
  })) << far->force_N().transpose()
      << " for " << host->snapshot().report.force.f_T_W().transpose();
}

TEST_P(Contract, OpenItPushesNotAndClosedItPushesNot) {
  std::unique_ptr<servo::DevicePort> arm = opened();
  EXPECT_TRUE(rests());
  arm.reset();
  EXPECT_TRUE(rests());
  pushOn();
  host.reset();
  EXPECT_TRUE(comes([this] { return rests(); })) << far->force_N().norm() << " N for good";
}

TEST_P(Contract, ACutEndsTheForceFromAnyThread) {
  const std::unique_ptr<servo::DevicePort> arm = opened();
  arm->cut();
  EXPECT_TRUE(comes([this] { return rests(); }));
}

TEST_P(Contract, StoppedItGoesToZeroAndStartedItPushesAgain) {
  pushOn();
  host->stop();
  EXPECT_TRUE(comes([this] { return host->snapshot().mode != servo::Mode::Running && rests(); }));
  host->start();
  EXPECT_TRUE(comes([this] { return (sent_N(), pushes()); }));
}

TEST_P(Contract, ASampleThatStandsStillLetsTheForceGo) {
  if (!far->mustMove()) GTEST_SKIP() << "this arm may stand still";
  pushOn();
  far->freeze(true);
  EXPECT_TRUE(comes([this] { return (host->snapshot(), rests()); }));
}

TEST_P(Contract, UnpluggedItRestsSaysWhyAndPushesOnlyAfterRestartAndStart) {
  if (!far->hasCable()) GTEST_SKIP() << "nobody can unplug it";
  pushOn();
  far->unplug();
  ASSERT_TRUE(comes([this] { return host->snapshot().mode == servo::Mode::Faulted; }));
  EXPECT_TRUE(comes([this] { return rests(); }));
  const std::string trouble = host->trouble();
  EXPECT_FALSE(trouble.empty());
  EXPECT_TRUE(trouble.empty() || trouble.back() == '.') << trouble;
  EXPECT_FALSE(host->restart().empty()) << "it is still unplugged";
  far->plugIn();
  std::this_thread::sleep_for(100ms);
  EXPECT_TRUE(rests()) << "nobody said Start";
  ASSERT_TRUE(comes([this] { return host->restart().empty(); }));
  std::this_thread::sleep_for(100ms);
  EXPECT_TRUE(rests()) << "nobody said Start";
  host->start();
  EXPECT_TRUE(comes([this] { return (sent_N(), pushes()); })) << host->trouble();
  EXPECT_EQ(host->trouble(), "");
}

TEST_P(Contract, AtRandomMomentsUnpluggedItRestsWithinFiveTicksOfItsOwn) {
  if (!far->hasCable()) GTEST_SKIP() << "nobody can unplug it";
  Random random(Seed{2026});
  for (int round = sweep(3, 1000); round > 0; --round) {
    pushOn();
    std::this_thread::sleep_for(std::chrono::duration<double>(random.between(0.0, 0.02)));
    far->unplug();
    const std::int64_t forces = far->forces();
    ASSERT_TRUE(comes([this] { return host->snapshot().mode == servo::Mode::Faulted && rests(); })) << round;
    EXPECT_LE(far->forces() - forces, 5 + far->unreadForces())
        << "forces that came after the cable was pulled, until zero";
    host.reset();
    far->plugIn();
  }
}

INSTANTIATE_TEST_SUITE_P(Drivers, Contract, testing::ValuesIn(drivers()),
                         [](const testing::TestParamInfo<Driver>& driver) { return driver.param.name; });

}  // namespace
}  // namespace underact::test
