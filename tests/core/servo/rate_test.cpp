// The servo's rate changes while the program runs.
#include <chrono>
#include <cmath>
#include <thread>

#include "core/servo/host.h"
#include "tests/core/servo/scripted_port.h"
#include "tests/support/comes.h"
#include "tests/support/property.h"

namespace underact::servo {
namespace {

using test::comes;
using test::ScriptedPort;
using namespace std::chrono_literals;

scene::Description softBall() {
  scene::Description scene;
  scene.title = "Ball";
  scene.control.gains.kp_N_per_mm.setConstant(0.05);
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 50.0}, target::Side::Both, {}, {}});
  return scene;
}

/// A servo that pushes with 0.5 N on an arm that takes any rate.
struct RateRig {
  explicit RateRig(const HostOptions& options = {1000, Clock::Manual},
                   const std::function<void(ScriptedPort&)>& prepare = {}) {
    auto port = std::make_unique<ScriptedPort>(seen, 100'000);
    port->takes_rates = true;
    if (prepare) prepare(*port);
    host = std::make_unique<Host>(std::move(port), options);
    EXPECT_TRUE(host->load(softBall()).empty());
    host->start();
  }
  std::vector<TickRecord> drained() {
    std::vector<TickRecord> rows;
    host->drain([&rows](const TickRecord& row) { rows.push_back(row); });
    return rows;
  }
  ScriptedPort::Seen seen;
  std::unique_ptr<Host> host;
};

/// The next sample after spoilt was set is no number; once.
std::function<void(ScriptedPort&)> spoiltBy(std::atomic<bool>& spoilt) {
  return [&spoilt](ScriptedPort& port) {
    port.spoil = [&spoilt](std::int64_t, arm::Sample& sample) {
      if (spoilt.exchange(false)) sample.q_rad[2] = kNotANumber;
      return true;
    };
  };
}

}  // namespace

TEST(ServoRate, TheForceIsLetGoAndComesBackSoftlyAndTheTimeOfSamplesGoesOn) {
  RateRig rig;
  rig.host->run(1000);
  ASSERT_NEAR(rig.seen.last_size_N, 0.5, 1e-9);
  ASSERT_TRUE(rig.host->setRate(4000).empty());
  EXPECT_EQ(rig.host->rateHz(), 4000);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  EXPECT_TRUE(rig.host->running());
  const std::int64_t before_ns = rig.host->snapshot().report.sample.time_ns;
  rig.host->run(4000);
  EXPECT_EQ(rig.host->snapshot().report.sample.time_ns - before_ns, 1'000'000'000);  // a second of them
  EXPECT_NEAR(rig.seen.last_size_N, 0.5, 1e-9);
  for (std::size_t i = 1; i < rig.seen.forces.size(); ++i) {
    // The whole force goes in 50 ms, and that at 1000 Hz: the fastest there is.
    ASSERT_LE((rig.seen.forces[i] - rig.seen.forces[i - 1]).norm(), 0.5 / 50 + 1e-9) << i;
  }
}

TEST(ServoRate, EveryTickIsDrainedOnceInOrderAndEvenly) {
  RateRig rig;
  std::vector<int> rates{250, 10'000, 500, 8000, 100, 2000, 1000, 4000, 300, 1000};
  std::int64_t tick = 0, time_ns = 0;
  int was_hz = 1000;
  for (const int rate_hz : rates) {
    rig.host->run(100);
    const std::int64_t changed_at = rig.host->snapshot().ticks;
    ASSERT_TRUE(rig.host->setRate(rate_hz).empty());
    const std::int64_t let_go_at = rig.host->snapshot().ticks;
    EXPECT_LE(let_go_at - changed_at, was_hz / 5);
    rig.host->run(100);
    for (const TickRecord& row : rig.drained()) {
      ASSERT_EQ(row.tick, ++tick);
      ASSERT_EQ(row.time_ns - time_ns, 1'000'000'000 / (row.tick <= let_go_at ? was_hz : rate_hz));
      ASSERT_EQ(row.fault, FaultKind::None);
      time_ns = row.time_ns;
    }
    was_hz = rate_hz;
  }
  EXPECT_EQ(rig.host->snapshot().dropped, 0);
}

TEST(ServoRate, RowsHaveRoomForFourSecondsAtTheNewRate) {
  RateRig rig({100, Clock::Manual});
  ASSERT_TRUE(rig.host->setRate(10'000).empty());
  rig.drained();
  rig.host->run(40'000);
  EXPECT_EQ(rig.host->snapshot().dropped, 0);
  rig.host->run(1000);
  EXPECT_GT(rig.host->snapshot().dropped, 0);
}

TEST(ServoRate, TimingIsOfThePresentRateAlone) {
  RateRig rig;
  rig.host->run(500);  // not drained yet: they were of the rate before
  ASSERT_TRUE(rig.host->setRate(2000).empty());
  rig.host->run(300);
  rig.drained();
  EXPECT_EQ(rig.host->timing().latenessHistogram().count(), 300);
}

TEST(ServoRate, AFaultHoldsTheLastSecondOfTheRateThatItCameAt) {
  std::atomic<bool> spoilt{false};
  RateRig rig({1000, Clock::Manual}, spoiltBy(spoilt));
  rig.host->run(1500);
  spoilt = true;
  rig.host->run(1);
  ASSERT_TRUE(rig.host->setRate(4000).empty());  // before anybody fetched it
  EXPECT_FALSE(rig.host->running()) << "another rate is no Start";
  rig.host->start();
  rig.host->run(6000);
  spoilt = true;
  rig.host->run(1);
  const std::optional<FaultReport> before = rig.host->takeFault(), after = rig.host->takeFault();
  ASSERT_TRUE(before && after);
  EXPECT_EQ(before->rate_hz, 1000);
  EXPECT_EQ(before->last_second.size(), 1000U);
  EXPECT_EQ(after->rate_hz, 4000);
  EXPECT_EQ(after->last_second.size(), 4000U);
  // The one that was given back after the change has room for a second, too.
  for (int fault = 0; fault < 4; ++fault) {
    rig.host->start();
    rig.host->run(5000);
    spoilt = true;
    rig.host->run(1);
    const std::optional<FaultReport> again = rig.host->takeFault();
    ASSERT_TRUE(again);
    EXPECT_EQ(again->last_second.size(), 4000U);
  }
}

TEST(ServoRate, AFaultWhileTheForceIsLetGoTakesAStart) {
  std::atomic<bool> spoilt{false};
  RateRig rig({1000, Clock::Manual}, spoiltBy(spoilt));
  rig.host->run(1500);
  spoilt = true;  // the next sample is the first one of the release
  ASSERT_TRUE(rig.host->setRate(4000).empty());
  EXPECT_EQ(rig.host->rateHz(), 4000);
  EXPECT_FALSE(rig.host->running());
  rig.host->run(4000);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  EXPECT_TRUE(rig.host->takeFault());
  rig.host->start();
  rig.host->run(4000);
  EXPECT_NEAR(rig.seen.last_size_N, 0.5, 1e-9);
}

TEST(ServoRate, IsRefusedWhileASessionIsRecorded) {
  RateRig rig;
  rig.host->run(10);
  const auto tap = std::make_shared<Tap>(1'000'000);
  rig.host->record(tap);
  const Problems problems = rig.host->setRate(2000);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems.front().sentence.find("recorded"), std::string::npos);
  EXPECT_EQ(rig.host->rateHz(), 1000);
  rig.host->run(100);
  EXPECT_GT(rig.seen.last_size_N, 0.0) << "nothing was let go";
  rig.host->endRecord();
  EXPECT_TRUE(rig.host->setRate(2000).empty());
}

TEST(ServoRate, IsRefusedByAnArmThatHasOneAloneAndOutsideItsRange) {
  RateRig rig({1000, Clock::Manual}, [](ScriptedPort& port) { port.takes_rates = false; });
  EXPECT_EQ(rig.host->setRate(2000).size(), 1U);
  EXPECT_TRUE(rig.host->setRate(1000).empty()) << "that it has";
  RateRig other;
  for (const int rate_hz : {0, -1, 99, 10'001}) EXPECT_EQ(other.host->setRate(rate_hz).size(), 1U) << rate_hz;
  EXPECT_EQ(other.host->rateHz(), 1000);
}

TEST(ServoRate, AServoThatStoodStillStaysSo) {
  RateRig rig;
  rig.host->stop();
  rig.host->run(200);
  ASSERT_TRUE(rig.host->setRate(500).empty());
  EXPECT_FALSE(rig.host->running());
  rig.host->run(500);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
}

TEST(ServoRateThread, ChangesTenTimesWhileItRunsUnderAStormOfEdits) {  // the thread sanitizer sees any race
  // A machine that stands still for a while is no race: neither late ticks nor a pause end it.
  RateRig rig({.rate_hz = 1000, .clock = Clock::Thread, .watchdog_s = 0.0, .max_late = 1'000'000});
  rig.host->begin();
  std::int64_t tick = 0;
  const int rates[] = {250, 4000, 500, 8000, 1000, 10'000, 100, 2000, 400, 1000};
  for (const int rate_hz : rates) {
    ASSERT_TRUE(comes([&] { return rig.host->snapshot().mode == Mode::Running && rig.seen.last_size_N > 0.0; }));
    scene::Description scene = rig.host->scene();
    scene.control.gains.kp_N_per_mm.setConstant(0.04 + 1e-6 * rate_hz);
    ASSERT_TRUE(rig.host->edit(scene).empty());
    ASSERT_TRUE(rig.host->setRate(rate_hz).empty());
    EXPECT_EQ(rig.host->rateHz(), rate_hz);
    EXPECT_TRUE(rig.host->running());
    const std::int64_t from = rig.host->snapshot().ticks;
    ASSERT_TRUE(comes([&] { return rig.host->snapshot().ticks >= from + 20; }));
    rig.host->drain([&](const TickRecord& row) { ASSERT_EQ(row.tick, ++tick); });
  }
  EXPECT_FALSE(rig.host->takeFault());
}

}  // namespace underact::servo
