#include "device/simulated_arm.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/arm/forward.h"
#include "core/safety/gate.h"
#include "device/catalogue.h"

namespace underact::device {
namespace {

SimulatedArm::Options touchOptions(const char* model, int rate_hz = 1000) {
  SimulatedArm::Options options;
  options.arm = *arm::findPreset("touch-measured");
  options.model = *sim::findArmModel(model);
  options.rate_hz = rate_hz;
  return options;
}

Vec3 tipOf(const arm::Sample& sample) {
  return arm::tipPosition(arm::findPreset("touch-measured")->geometry, sample.q_rad);
}

/// What only the gate can make: a force within 0.88 N, fully ramped.
safety::GatedForce gated(const Vec3& f_T_W) {
  safety::GateState state;
  state.level = 1.0;
  safety::GateInput asked;
  asked.f_T_W = f_T_W;
  asked.engage = true;
  return safety::gate({0.88}, state, asked, 0.001).force;
}

/// A wall along x at the arm's start, by hand: what a servo would write for this sample.
safety::GatedForce wall(const arm::Sample& sample) {
  return gated(Vec3(-200.0 * tipOf(sample).x(), 0.0, 0.0));
}

TEST(SimulatedArm, TheStylusButtonIsBitZeroFromTheNextReadOn) {
  SimulatedArm arm(touchOptions("ideal"));
  arm::Sample sample;
  arm.read(sample);
  EXPECT_EQ(sample.buttons, 0U);
  arm.holdButton(true);
  for (int read = 0; read < 3; ++read) {
    arm.read(sample);
    EXPECT_EQ(sample.buttons, 1U);
  }
  arm.holdButton(false);
  arm.read(sample);
  EXPECT_EQ(sample.buttons, 0U);
}

TEST(SimulatedArm, EachReadIsOnePeriodLater) {
  for (const int rate_hz : {1000, 4000, 100}) {
    SimulatedArm arm(touchOptions("vendor-nominal", rate_hz));
    arm::Sample sample;
    for (int read = 1; read <= 5; ++read) {
      ASSERT_TRUE(arm.read(sample));
      EXPECT_EQ(sample.time_ns, read * (1'000'000'000 / rate_hz));
    }
  }
}

TEST(SimulatedArm, AtAnotherRateItsTimeAndItsHandGoOn) {
  EXPECT_EQ(SimulatedArm(touchOptions("ideal")).fixedRateReason(), "");
  SimulatedArm arm(touchOptions("ideal"));
  arm.follow(sim::builtInHand("sweep", 1).value());
  arm::Sample sample;
  std::int64_t time_ns = 0;
  Vec3 p_WT = Vec3::Zero();
  for (const int rate_hz : {1000, 250, 8000, 1000}) {
    arm.setRate(rate_hz);
    for (int read = 0; read < rate_hz; ++read) {
      ASSERT_TRUE(arm.read(sample));
      time_ns += 1'000'000'000 / rate_hz;
      ASSERT_EQ(sample.time_ns, time_ns);
      // 4 ms at 1 m/s, which the hand does not reach, and a step of the encoders.
      if (time_ns > 4'000'000) {
        ASSERT_LT((tipOf(sample) - p_WT).norm(), 0.0041);
      }
      p_WT = tipOf(sample);
    }
  }
}

TEST(SimulatedArm, LeftAloneItRestsWhereItStarted) {
  SimulatedArm arm(touchOptions("ideal"));
  arm::Sample sample;
  for (int read = 0; read < 1000; ++read) arm.read(sample);
  EXPECT_LE((tipOf(sample) - Vec3(0.0, 0.0, 0.06)).norm(), 2e-15);  // inverse_test: a tip found again
  EXPECT_EQ(arm.setpoint().p_WT, Vec3(0.0, 0.0, 0.06));
}

TEST(SimulatedArm, ShowsStepsOrExactAnglesAsItsModelSays) {
  SimulatedArm stepped(touchOptions("vendor-nominal")), exact(touchOptions("ideal"));
  arm::Sample coarse, fine;
  stepped.read(coarse);
  exact.read(fine);
  EXPECT_EQ(coarse.q_rad, sim::quantized(*arm::findPreset("touch-measured"), fine.q_rad));
  EXPECT_NE(coarse.q_rad, fine.q_rad);
}

TEST(SimulatedArm, StartsWhereItsScriptStarts) {
  SimulatedArm arm(touchOptions("ideal"));
  sim::HandScript script;
  script.path = {{0.0, Vec3(0.02, 0.01, 0.04)}};
  arm.follow(script);
  arm::Sample sample;
  arm.read(sample);
  EXPECT_LE((tipOf(sample) - Vec3(0.02, 0.01, 0.04)).norm(), 2e-15);
  EXPECT_EQ(arm.setpoint().p_WT, Vec3(0.02, 0.01, 0.04));
}

TEST(SimulatedArm, FollowsAScriptFromThenOnWithTheScriptsHand) {
  SimulatedArm arm(touchOptions("ideal"));
  arm::Sample sample;
  for (int read = 0; read < 2000; ++read) arm.read(sample);
  sim::HandScript script;
  script.hand.stiffness_N_per_m = 600.0;
  script.path = {{0.0, Vec3(0.0, 0.0, 0.06)}, {1.0, Vec3(0.0, 0.0, 0.04)}};
  arm.follow(script);
  arm.read(sample);
  EXPECT_LE((tipOf(sample) - Vec3(0.0, 0.0, 0.06)).norm(), 1e-9);  // 10 s^3 of 20 mm, 1 ms into the second
  arm.write(gated(Vec3(0.6, 0.0, 0.0)));
  for (int read = 0; read < 5000; ++read) arm.read(sample);
  EXPECT_LE((tipOf(sample) - Vec3(0.6 / 600.0, 0.0, 0.04)).norm(), 2e-15);  // inverse_test: a tip found again
}

TEST(SimulatedArm, AForceStaysInEffectUntilTheNextIsWritten) {
  SimulatedArm arm(touchOptions("ideal"));
  arm.write(gated(Vec3(0.6, 0.0, 0.0)));
  arm::Sample sample;
  for (int read = 0; read < 5000; ++read) arm.read(sample);
  EXPECT_NEAR(tipOf(sample).x(), 0.6 / 300.0, 2e-15);  // the hand's spring: 300 N/m
  arm.write({});
  for (int read = 0; read < 5000; ++read) arm.read(sample);
  EXPECT_NEAR(tipOf(sample).x(), 0.0, 2e-15);
}

TEST(SimulatedArm, AMouseThatJumpsIsFollowedAtAFiniteSpeed) {
  SimulatedArm arm(touchOptions("ideal"));
  sim::HandSetpoint setpoint;
  setpoint.p_WT = Vec3(0.04, 0.0, 0.06);
  arm.setSetpoint(setpoint);
  EXPECT_EQ(arm.setpoint().p_WT, setpoint.p_WT);
  arm::Sample sample;
  Vec3 last = Vec3(0.0, 0.0, 0.06);
  double fastest_m_per_s = 0.0;
  for (int read = 0; read < 500; ++read) {
    arm.read(sample);
    fastest_m_per_s = std::max(fastest_m_per_s, (tipOf(sample) - last).norm() / 0.001);
    last = tipOf(sample);
  }
  // The filter's own fastest is 40 mm / 16 ms = 2.5 m/s; behind the hand's mass the tip stays below it.
  EXPECT_LT(fastest_m_per_s, 2.5);
  EXPECT_GT(fastest_m_per_s, 0.5);
  // After 0.5 s: 33 time constants of the filter, 10 of the hand (2 M / b = 50 ms): e^-10 of 40 mm.
  EXPECT_LE((last - setpoint.p_WT).norm(), 0.04 * 1e-4);
}

TEST(SimulatedArm, BehindAMouseThatMovesEvenlyItLagsByTheFilterAlone) {
  SimulatedArm arm(touchOptions("ideal"));
  arm::Sample sample;
  sim::HandSetpoint setpoint;
  for (int read = 1; read <= 800; ++read) {  // 50 mm/s, from -20 mm to 20 mm
    setpoint.p_WT = Vec3(-0.020 + 50e-6 * read, 0.0, 0.06);
    arm.setSetpoint(setpoint);
    arm.read(sample);
  }
  // 15 ms of 50 mm/s. The start has died down: 0.8 s, 16 time constants of the hand (2 M / b), e^-16 of 20 mm.
  EXPECT_NEAR(setpoint.p_WT.x() - tipOf(sample).x(), 0.015 * 0.05, 2e-8);
}

/// Speeds of the hand itself, m/s, tick by tick, while it is told 100 mm in a second in so many events.
std::vector<double> draggedSpeeds(const std::vector<int>& event_ms) {
  SimulatedArm arm(touchOptions("ideal"));
  arm::Sample sample;
  sim::HandSetpoint setpoint = arm.setpoint();
  setpoint.p_WT = Vec3(-0.05, 0.0, 0.02);
  arm.glideTo(setpoint);
  for (int read = 0; read < 3000; ++read) arm.read(sample);
  const Vec3 begin_W = setpoint.p_WT;
  std::vector<double> speeds;
  Vec3 last = tipOf(sample);
  std::size_t next = 0;
  for (int ms = 0; ms < 1100; ++ms) {
    for (; next < event_ms.size() && event_ms[next] == ms; ++next) {
      setpoint.p_WT = begin_W + Vec3(1e-4 * ms, 0.0, 0.0);
      arm.glideTo(setpoint);
    }
    arm.read(sample);
    speeds.push_back((tipOf(sample) - last).norm() / 0.001);
    last = tipOf(sample);
  }
  return speeds;
}

TEST(SimulatedArm, AHandThatIsToldTenPlacesASecondMovesEvenlyBetweenThem) {
  for (const int apart_ms : {100, 50, 17, 8}) {
    std::vector<int> events;
    for (int ms = apart_ms; ms <= 1000; ms += apart_ms) events.push_back(ms);
    const std::vector<double> speeds = draggedSpeeds(events);
    double slowest = kInfinity, fastest = 0.0;
    for (std::size_t ms = 300; ms <= 1000; ++ms) {
      slowest = std::min(slowest, speeds[ms]);
      fastest = std::max(fastest, speeds[ms]);
    }
    EXPECT_GT(slowest, 0.090) << apart_ms << " ms apart";
    EXPECT_LT(fastest, 0.110) << apart_ms << " ms apart";
  }
}

TEST(SimulatedArm, AWishThatIsNoPlaceIsNotHeard) {
  SimulatedArm arm(touchOptions("ideal"));
  sim::HandSetpoint setpoint;
  setpoint.p_WT = Vec3(0.0, kNotANumber, 0.0);
  arm.setSetpoint(setpoint);
  arm::Sample sample;
  arm.read(sample);
  EXPECT_LE((tipOf(sample) - Vec3(0.0, 0.0, 0.06)).norm(), 2e-15);
  EXPECT_TRUE(arm.setpoint().p_WT.allFinite());
}

TEST(SimulatedArm, LooseFingersGoWhereTheForceGoesAndTakeHoldThereWithoutAJerk) {
  SimulatedArm arm(touchOptions("ideal"));
  sim::HandSetpoint setpoint = arm.setpoint();
  setpoint.holds = false;
  arm.setSetpoint(setpoint);
  const auto push = [&arm](int reads, const Vec3& f_T_W) {
    arm::Sample sample;
    for (int read = 0; read < reads; ++read) {
      arm.read(sample);
      arm.write(gated(f_T_W));
    }
    return tipOf(sample);
  };
  const Vec3 pushed = push(500, Vec3(0.4, 0.0, 0.0));
  // 0.4 N against the hand's damper alone, 4 N s/m, is 0.1 m/s, after 0.1 kg / 4 N s/m = 25 ms.
  EXPECT_NEAR(pushed.x(), 0.1 * (0.5 - 0.025), 0.001);
  const Vec3 rest = push(500, Vec3::Zero());
  servo::Truth truth;
  ASSERT_TRUE(arm.truth(truth));
  EXPECT_LT(truth.f_hand_T_W.norm(), 1e-6) << "nothing pulls it back";
  setpoint.p_WT = rest;
  setpoint.holds = true;
  arm.setSetpoint(setpoint);
  EXPECT_LT((push(500, Vec3::Zero()) - rest).norm(), 1e-9);
}

TEST(SimulatedArm, AWishTakesTheStylusFromAScriptWithoutAJump) {
  SimulatedArm arm(touchOptions("ideal"));
  arm.follow(sim::builtInHand("still", 0).value());
  arm::Sample sample;
  for (int read = 0; read < 3000; ++read) arm.read(sample);
  const Vec3 held = tipOf(sample);
  sim::HandSetpoint setpoint;
  setpoint.p_WT = held;
  arm.setSetpoint(setpoint);
  for (int read = 0; read < 3000; ++read) {
    arm.read(sample);
    ASSERT_LE((tipOf(sample) - held).norm(), 1e-12)
        << read;  // what is left of the approach: e^-40 of 51 mm, and rounding
  }
  setpoint.p_WT = Vec3(0.0, 0.0, 0.05);
  arm.setSetpoint(setpoint);
  for (int read = 0; read < 3000; ++read) arm.read(sample);
  EXPECT_LE((tipOf(sample) - setpoint.p_WT).norm(), 1e-12);
}

TEST(SimulatedArm, GivesTheSameNumbersLiveAndFast) {
  SimulatedArm live(touchOptions("vendor-nominal")), fast(touchOptions("vendor-nominal"));
  live.follow(sim::builtInHand("tremor", 9).value());
  fast.follow(sim::builtInHand("tremor", 9).value());
  arm::Sample live_sample, fast_sample;
  for (int read = 0; read < 300; ++read) {
    if (read < 100) std::this_thread::sleep_for(std::chrono::microseconds(200 * (read % 5)));
    live.read(live_sample);
    fast.read(fast_sample);
    ASSERT_EQ(live_sample.time_ns, fast_sample.time_ns);
    ASSERT_EQ(live_sample.q_rad, fast_sample.q_rad);
    live.write(wall(live_sample));
    fast.write(wall(fast_sample));
  }
}

TEST(SimulatedArm, WishesComeFromAnotherThreadWhole) {  // and ThreadSanitizer watches
  SimulatedArm arm(touchOptions("ideal"));
  std::atomic<bool> done{false};
  std::thread mouse([&] {
    for (int step = 0; !done.load(); ++step) {
      sim::HandSetpoint setpoint;
      setpoint.p_WT = Vec3::Constant(0.0001 * (step % 200)) + Vec3(0.0, 0.0, 0.02);
      arm.setSetpoint(setpoint);
    }
  });
  arm::Sample sample;
  for (int read = 0; read < 20000; ++read) arm.read(sample);
  done = true;
  mouse.join();
  // x and y were always wished the same, so a wish torn in two would part them for good.
  EXPECT_NEAR(tipOf(sample).x(), tipOf(sample).y(), 1e-14);
}

TEST(SimulatedArm, SaysThatItIsSimulated) {
  const servo::DeviceInfo info = SimulatedArm(touchOptions("ideal")).info();
  EXPECT_EQ(info.title, "Simulated arm");
  EXPECT_TRUE(info.simulated);
  EXPECT_FALSE(info.untested);
}

Request requestFor(const char* address) {
  Request request;
  request.arm = *arm::findPreset("touch-measured");
  request.model = *sim::findArmModel("ideal");
  request.rate_hz = 500;
  request.address = address;
  return request;
}

TEST(Catalogue, OpensTheSimulatedArm) {
  const Driver& driver = *findDevice("simulated");
  const Result<std::unique_ptr<servo::DevicePort>> port = driver.open(requestFor(""));
  ASSERT_TRUE(port);
  EXPECT_EQ(port.value()->info().title, driver.name);
  arm::Sample sample;
  EXPECT_TRUE(port.value()->read(sample));
  EXPECT_EQ(sample.time_ns, 2'000'000);
}

TEST(SimulatedArm, BecomesAnotherArmAtItsTipAndBeginsANewEpoch) {
  const arm::Preset& omni = *arm::findPreset("omni-thesis");
  SimulatedArm arm(touchOptions("ideal"));
  arm::Sample sample;
  arm.read(sample);
  const Vec3 p_WT = tipOf(sample);
  EXPECT_EQ(sample.epoch, 0U);
  arm.become(*arm::findPreset("touch-measured"));  // the same: nothing begins anew
  arm.read(sample);
  EXPECT_EQ(sample.epoch, 0U);
  arm.become(omni);
  arm.read(sample);
  EXPECT_EQ(sample.epoch, 1U);
  EXPECT_LT((arm::tipPosition(omni.geometry, sample.q_rad) - p_WT).norm(), 1e-12);
  EXPECT_GT((tipOf(sample) - p_WT).norm(), 1e-3);
  arm.become(*sim::findArmModel("vendor-nominal"));  // another model of the same arm
  arm.read(sample);
  EXPECT_EQ(sample.epoch, 1U);
  EXPECT_LT((arm::tipPosition(omni.geometry, sample.q_rad) - p_WT).norm(), 1e-4);
}

TEST(Catalogue, EachRowReportsAnAbsentArmInASentence) {
  EXPECT_EQ(findDevice("omni"), nullptr);
  for (const Driver& driver : catalogue()) {
    ASSERT_EQ(findDevice(driver.key), &driver);
    for (const Found& found : driver.search()) EXPECT_NE(found.title, "") << driver.key;
    if (std::string_view(driver.key) == "simulated") continue;
    const Result<std::unique_ptr<servo::DevicePort>> port = driver.open(requestFor("nobody has an arm of this name"));
    ASSERT_FALSE(port) << driver.key;
    EXPECT_EQ(port.problems().front().sentence.back(), '.') << port.problems().front().sentence;
  }
}

}  // namespace
}  // namespace underact::device
