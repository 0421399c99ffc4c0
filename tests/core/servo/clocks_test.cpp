// Clocks that are none, and a machine that sleeps: at the servo as a whole.
#include <cmath>
#include <limits>
#include <utility>

#include "core/scene/compile.h"
#include "core/servo/host.h"
#include "core/servo/loop.h"
#include "tests/core/servo/scripted_port.h"
#include "tests/support/comes.h"
#include "tests/support/property.h"

namespace underact::servo {
namespace {

using test::comes;
using test::ScriptedPort;

constexpr std::int64_t kTick_ns = 1'000'000, kOneSecond_ns = 1'000'000'000;

scene::Description clockBall() {
  scene::Description scene;
  scene.title = "Ball";
  scene.control.gains.kp_N_per_mm.setConstant(0.05);
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 50.0}, target::Side::Both, {}, {}});
  return scene;
}

/// A servo of 1 kHz that pushes with 0.5 N, ticked by hand; its arm's clock goes wrong when it is told to.
struct ClockRig {
  ClockRig() {
    auto port = std::make_unique<ScriptedPort>(seen, 20'000);
    port->spoil = [this](std::int64_t, arm::Sample& sample) {
      time_ns = is_odd ? odd(time_ns) : time_ns + kTick_ns;
      sample.time_ns = time_ns;
      sample.epoch = epoch;
      return true;
    };
    host = std::make_unique<Host>(std::move(port), HostOptions{1000, Clock::Manual});
    EXPECT_TRUE(host->load(clockBall()).empty());
  }
  void push() {
    host->start();
    host->run(400);
    ASSERT_NEAR(seen.last_size_N, 0.5, 1e-9);
  }
  ScriptedPort::Seen seen;
  std::int64_t time_ns = 0;
  std::uint32_t epoch = 0;
  bool is_odd = false;
  std::function<std::int64_t(std::int64_t)> odd = [](std::int64_t now_ns) { return now_ns; };
  std::unique_ptr<Host> host;
};

std::function<std::int64_t(std::int64_t)> atRate(double rate) {
  return [rate](std::int64_t now_ns) { return now_ns + static_cast<std::int64_t>(rate * kTick_ns); };
}

/// A clock with sleep that the test sets; the other one is the machine's.
std::atomic<std::int64_t> slept_ns{0};
std::int64_t asleepNow_ns() noexcept {
  return system::monotonicNow_ns() + slept_ns;
}
const system::Clocks kSleepy{system::monotonicNow_ns, asleepNow_ns};

/// A loop with a clock, ticked by hand.
struct SleepRig {
  SleepRig() {
    scene::Description scene = clockBall();
    tick::TickProgram program = scene::compile(scene).value();
    tick::TickState state = tick::makeState(program);
    loop.send({Order::Load, new Instance{std::move(program), std::move(state), 1}});
  }
  void run(int ticks) {
    for (int tick = 0; tick < ticks; ++tick) {
      Wake wake;
      // As late as the clock of the samples says, for that is what is not tried here.
      wake.at_ns = at_ns += kTick_ns;
      loop.tick(wake);
    }
  }
  void push() {
    loop.send({Order::Start});
    run(400);
    ASSERT_GT(seen.last_size_N, 0.4);
  }
  Fault fault() { return loop.snapshot().report.fault; }
  ScriptedPort::Seen seen;
  ScriptedPort port{seen, 20'000};
  std::int64_t at_ns = system::monotonicNow_ns();
  ServoLoop loop{port, kTick_ns, 100 * kTick_ns, kSleepy};
};

}  // namespace

TEST(ArmsClock, AfterStopTheForceIsGoneWithinTheReleaseWhateverItSays) {
  for (const double rate : {0.0, 0.01, 0.5, 1.0, 2.0, 99.0, 101.0, 1000.0, 3.6e6}) {
    ClockRig rig;
    rig.push();
    rig.odd = atRate(rate);
    rig.is_odd = true;
    rig.host->stop();
    rig.host->run(51);
    EXPECT_EQ(rig.seen.last_size_N, 0.0) << rate;
    const std::size_t there = rig.seen.forces.size();
    rig.host->run(1000);
    for (std::size_t index = there; index < rig.seen.forces.size(); ++index)
      ASSERT_EQ(rig.seen.forces[index], Vec3(Vec3::Zero())) << rate;
  }
}

TEST(ArmsClock, ThatDisagreesWithTheServosIsAFaultWithASentenceAndPushesOnStartAlone) {
  for (const double rate : {0.01, 0.5, 2.0, 100.0, 1000.0}) {
    ClockRig rig;
    rig.push();
    rig.odd = atRate(rate);
    rig.is_odd = true;
    rig.host->run(400);
    EXPECT_EQ(rig.seen.last_size_N, 0.0) << rate;
    EXPECT_EQ(rig.host->snapshot().mode, Mode::Faulted) << rate;
    const std::optional<FaultReport> report = rig.host->takeFault();
    ASSERT_TRUE(report) << rate;
    EXPECT_EQ(report->fault.kind, FaultKind::OddClock) << rate;
    EXPECT_NE(describe(report->fault).find("The arm's clock advanced by "), std::string::npos);
    rig.is_odd = false;
    rig.host->run(1000);
    EXPECT_EQ(rig.seen.last_size_N, 0.0) << "it takes a Start";
    rig.push();
  }
}

TEST(ArmsClock, ThatLeapsIsAFaultInThatTick) {
  for (const std::int64_t leap_ns :
       {200 * kTick_ns, 3600 * kOneSecond_ns, std::numeric_limits<std::int64_t>::max() / 2}) {
    ClockRig rig;
    rig.push();
    rig.odd = [leap_ns](std::int64_t now_ns) { return now_ns + leap_ns; };
    rig.is_odd = true;
    rig.host->run(1);
    EXPECT_EQ(rig.seen.last_size_N, 0.0) << leap_ns;
    EXPECT_EQ(rig.host->snapshot().report.fault.kind, FaultKind::OddClock) << leap_ns;
  }
  for (const std::int64_t leap_ns : {200 * kTick_ns, 3600 * kOneSecond_ns}) {
    ClockRig rig;
    rig.push();
    rig.time_ns -= leap_ns;  // back, and on from there
    rig.host->run(21);
    EXPECT_EQ(rig.seen.last_size_N, 0.0) << leap_ns;
    EXPECT_EQ(rig.host->snapshot().report.fault.kind, FaultKind::StaleSample) << leap_ns;
  }
}

TEST(ArmsClock, ThatStandsStillIsAnOldSample) {
  ClockRig rig;
  rig.push();
  rig.is_odd = true;
  rig.host->run(1);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  rig.host->run(20);
  EXPECT_EQ(rig.host->snapshot().report.fault.kind, FaultKind::StaleSample);
}

TEST(ArmsClock, MayBeWhatItLikesWhereNothingPushesAndCountsAnewWithAnArmThatBeginsAnew) {
  ClockRig rig;
  rig.odd = atRate(1000.0);
  rig.is_odd = true;
  rig.host->run(1000);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Idle);
  rig.is_odd = false;
  rig.push();
  rig.time_ns += 3600 * kOneSecond_ns;
  ++rig.epoch;
  rig.host->run(1000);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Running);
  EXPECT_FALSE(rig.host->takeFault());
}

TEST(Asleep, AMachineThatSleptPushesOnStartAlone) {
  SleepRig rig;
  rig.push();
  slept_ns += 7200 * kOneSecond_ns;
  rig.run(1);
  EXPECT_EQ(rig.seen.last_size_N, 0.0) << "no force before the fault";
  EXPECT_EQ(rig.fault().kind, FaultKind::Asleep);
  EXPECT_NEAR(rig.fault().seen, 7200.0, 0.01);
  EXPECT_EQ(describe({FaultKind::Asleep, 7200.0, 0.0}),
            "The computer was asleep for 7200.0 s. Force is off. Press Start to continue.");
  rig.run(500);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  rig.push();
}

// Between any two instructions: before the sample, between sample and force, while the force is being written.
TEST(Asleep, WhereverInATickItFellAsleepTheForceThatIsLeftIsZero) {
  for (const int where : {0, 1}) {
    SleepRig rig;
    rig.push();
    std::int64_t sleeps_ns = kOneSecond_ns;
    const auto sleep = [&sleeps_ns] { slept_ns += std::exchange(sleeps_ns, 0); };
    rig.port.spoil = [&](std::int64_t, arm::Sample&) {
      if (where == 0) sleep();
      return true;
    };
    rig.port.written = [&] {
      if (where == 1) sleep();
    };
    rig.run(1);
    EXPECT_EQ(rig.seen.last_size_N, 0.0) << where;
    const std::size_t there = rig.seen.forces.size();
    rig.run(2);
    EXPECT_EQ(rig.fault().kind, FaultKind::Asleep) << where;
    for (std::size_t index = there; index < rig.seen.forces.size(); ++index)
      EXPECT_EQ(rig.seen.forces[index], Vec3(Vec3::Zero())) << where;
  }
}

TEST(Asleep, WhereNothingPushedItIsNoFault) {
  SleepRig rig;
  rig.run(100);
  slept_ns += kOneSecond_ns;
  rig.run(100);
  EXPECT_EQ(rig.loop.snapshot().mode, Mode::Idle);
  rig.push();
  rig.loop.send({Order::Stop});
  rig.run(100);
  rig.loop.release();  // its thread rests
  slept_ns += kOneSecond_ns;
  rig.push();
}

TEST(Asleep, AServosOwnThreadFindsIt) {
  ScriptedPort::Seen seen;
  Host host(std::make_unique<ScriptedPort>(seen), HostOptions{.max_late = 1'000'000, .clocks = kSleepy});
  ASSERT_TRUE(host.load(clockBall()).empty());
  host.start();
  host.begin();
  ASSERT_TRUE(comes([&] { return (host.snapshot(), seen.last_size_N > 0.4); }));
  slept_ns += 60 * kOneSecond_ns;
  ASSERT_TRUE(comes([&] { return host.snapshot().mode == Mode::Faulted; }));
  EXPECT_EQ(host.takeFault()->fault.kind, FaultKind::Asleep);
  EXPECT_EQ(seen.last_size_N, 0.0);
  host.start();
  EXPECT_TRUE(comes([&] { return (host.snapshot(), seen.last_size_N > 0.4); }));
}

TEST(Asleep, TheMachinesOwnClocksAgreeWhileItIsAwake) {
  SleepWatch watch;
  const system::Clocks clocks;
  for (int look = 0; look < 100'000; ++look) ASSERT_EQ(watch.poll(clocks), 0);
}

}  // namespace underact::servo
