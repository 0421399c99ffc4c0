// Everything that can go wrong on the way from the arm to the hand and to the disk, tried: the rows of the table in
// resources/guide/faults.md. What takes the program's life is in tests/process; what happens in the window, in
// tests/stories.
#include <atomic>
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

scene::Description ball(double radius_mm = 50.0) {
  scene::Description scene;
  scene.title = "Ball";
  scene.control.gains.kp_N_per_mm.setConstant(0.05);
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), radius_mm}, target::Side::Both, {}, {}});
  return scene;
}

/// A servo that pushes with 0.5 N, by hand, on an arm that `prepare` spoils.
struct InjectionRig {
  explicit InjectionRig(const std::function<void(ScriptedPort&)>& prepare,
                        const HostOptions& options = {1000, Clock::Manual}) {
    auto port = std::make_unique<ScriptedPort>(seen, 20'000);
    prepare(*port);
    host = std::make_unique<Host>(std::move(port), options);
    EXPECT_TRUE(host->load(ball()).empty());
    host->start();
  }
  double force_N() const { return seen.last_size_N; }
  FaultKind fault() { return host->snapshot().report.fault.kind; }
  ScriptedPort::Seen seen;
  std::unique_ptr<Host> host;
};

}  // namespace

TEST(Injection, AFewMissedSamplesAreZeroForceThenASoftStart) {
  InjectionRig rig([](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample&) { return read < 700 || read >= 710; };
  });
  rig.host->run(699);
  ASSERT_NEAR(rig.force_N(), 0.5, 1e-9);
  rig.host->run(1);
  EXPECT_EQ(rig.force_N(), 0.0);
  rig.host->run(10);
  EXPECT_NEAR(rig.force_N(), 0.5 * 1 / 300, 1e-9);
  rig.host->run(300);
  EXPECT_NEAR(rig.force_N(), 0.5, 1e-9);
  EXPECT_FALSE(rig.host->takeFault());
}

TEST(Injection, AnOldSampleIsZeroForceAndAFaultWhenItStaysOld) {
  InjectionRig rig([](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample& sample) {
      if (read >= 700) sample.time_ns = 699'000'000;
      return true;
    };
  });
  rig.host->run(700);
  EXPECT_EQ(rig.force_N(), 0.0);
  rig.host->run(20);
  EXPECT_EQ(rig.fault(), FaultKind::StaleSample);
}

TEST(Injection, AFrozenSampleIsLetGoSoftlyAndComesBackWithTheHand) {
  InjectionRig rig([](ScriptedPort& port) {
    port.frozen_s = 0.5;
    port.tip = [](std::int64_t read) {  // a tremble of 1 um, but for two seconds of none
      const bool frozen = read >= 1000 && read < 3000;
      return Vec3(0.0, 0.0, 0.06 + (frozen || read % 2 == 0 ? 0.0 : 1e-6));
    };
  });
  rig.host->run(1000);
  ASSERT_NEAR(rig.force_N(), 0.5, 1e-3);
  rig.host->run(600);
  EXPECT_EQ(rig.force_N(), 0.0);
  EXPECT_TRUE(rig.host->snapshot().report.cuts.frozen);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Running) << "no fault: it may just have been laid down";
  rig.host->run(2000);
  EXPECT_NEAR(rig.force_N(), 0.5, 1e-3);
}

TEST(Injection, APositionThatJumpsIsAFault) {
  InjectionRig rig([](ScriptedPort& port) {
    port.tip = [](std::int64_t read) { return Vec3(read == 700 ? 0.03 : 0.0, 0.0, 0.06); };
  });
  rig.host->run(700);
  EXPECT_EQ(rig.force_N(), 0.0);
  EXPECT_EQ(rig.fault(), FaultKind::TooFast);
  const std::optional<FaultReport> report = rig.host->takeFault();
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->fault.seen, 30.0, 1e-6);
}

TEST(Injection, ADeviceThatIsGoneIsAFaultAndComesBackWithARestart) {
  std::atomic<bool> is_there{true};
  bool opens = false;
  InjectionRig rig([&](ScriptedPort& port) {
    port.spoil = [&](std::int64_t, arm::Sample&) { return is_there.load(); };
    port.opens_again = [&]() -> Problems {
      if (!opens) return {{"The arm is not plugged in.", {}}};
      is_there = true;
      return {};
    };
  });
  rig.host->run(700);
  is_there = false;
  rig.host->run(1);
  EXPECT_EQ(rig.force_N(), 0.0);
  rig.host->run(20);
  EXPECT_EQ(rig.fault(), FaultKind::NoSample);
  const Problems problems = rig.host->restart();
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].sentence, "The arm is not plugged in.");
  opens = true;
  EXPECT_TRUE(rig.host->restart().empty());
  rig.host->run(10);
  EXPECT_EQ(rig.force_N(), 0.0) << "it takes a Start";
  rig.host->start();
  rig.host->run(400);
  EXPECT_NEAR(rig.force_N(), 0.5, 1e-9);
}

TEST(Injection, AStepOfTheArmsClockForwardIsAFault) {
  InjectionRig rig([](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample& sample) {
      if (read >= 700) sample.time_ns += 3'600'000'000'000;
      return true;
    };
  });
  rig.host->run(699);
  ASSERT_NEAR(rig.force_N(), 0.5, 1e-9);
  rig.host->run(1);
  EXPECT_EQ(rig.force_N(), 0.0);
  EXPECT_EQ(rig.fault(), FaultKind::OddClock);
  EXPECT_NEAR(rig.host->snapshot().report.fault.seen, 3600.0, 1.0);
  rig.host->start();
  rig.host->run(400);
  EXPECT_NEAR(rig.force_N(), 0.5, 1e-9) << "Start counts the arm's time anew";
}

TEST(Injection, AStepOfTheArmsClockBackIsAFault) {
  InjectionRig rig([](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample& sample) {
      if (read >= 700) sample.time_ns -= 500'000'000;
      return true;
    };
  });
  rig.host->run(721);
  EXPECT_EQ(rig.force_N(), 0.0);
  EXPECT_EQ(rig.fault(), FaultKind::StaleSample);
  rig.host->start();
  rig.host->run(400);
  EXPECT_NEAR(rig.force_N(), 0.5, 1e-9) << "Start counts the arm's time anew";
}

TEST(Injection, AReadThatHangsIsCutByTheWatchdogAndIsAFaultWhenItComesBack) {
  std::atomic<bool> hangs{false};
  InjectionRig rig(
      [&](ScriptedPort& port) {
        port.spoil = [&](std::int64_t, arm::Sample&) {
          while (hangs.load()) std::this_thread::sleep_for(1ms);
          return true;
        };
      },
      {1000, Clock::Thread});
  rig.host->begin();
  ASSERT_TRUE(comes([&] { return rig.force_N() > 0.49; }));
  hangs = true;
  EXPECT_TRUE(comes([&] { return rig.seen.cuts > 0; })) << "the servo hangs, and nobody let go";
  hangs = false;
  ASSERT_TRUE(comes([&] { return rig.host->snapshot().mode == Mode::Faulted; }));
  EXPECT_EQ(rig.fault(), FaultKind::StoodStill);
  EXPECT_EQ(rig.force_N(), 0.0);
  EXPECT_GE(rig.host->snapshot().report.fault.seen, 0.1);
  rig.host->start();
  EXPECT_TRUE(comes([&] { return rig.force_N() > 0.49; }));
}

TEST(Injection, TicksThatAreLateAllTheTimeLetGo) {
  std::atomic<bool> slow{false};
  InjectionRig rig(
      [&](ScriptedPort& port) {
        port.spoil = [&](std::int64_t, arm::Sample&) {
          if (slow.load()) std::this_thread::sleep_for(3ms);
          return true;
        };
      },
      {1000, Clock::Thread});
  rig.host->begin();
  ASSERT_TRUE(comes([&] { return rig.force_N() > 0.49; }));
  slow = true;
  ASSERT_TRUE(comes([&] { return rig.host->snapshot().mode == Mode::Faulted; }));
  EXPECT_EQ(rig.fault(), FaultKind::TooLate);
  EXPECT_GT(rig.host->snapshot().late.total, 20);
  EXPECT_GT(rig.host->snapshot().late.left_out, 20) << "what has passed is not caught up";
}

TEST(Injection, HowManyLateTicksAreBorneIsToChoose) {
  InjectionRig rig(
      [&](ScriptedPort& port) {
        port.spoil = [](std::int64_t, arm::Sample&) {
          std::this_thread::sleep_for(3ms);
          return true;
        };
      },
      {.clock = Clock::Thread, .max_late = 3});
  rig.host->begin();
  ASSERT_TRUE(comes([&] { return rig.host->snapshot().mode == Mode::Faulted; }));
  EXPECT_EQ(rig.fault(), FaultKind::TooLate);
  EXPECT_EQ(rig.host->snapshot().report.fault.allowed, 3.0);
}

TEST(Injection, AThousandScenesAreSwappedWhileItPushesAndNoStepIsFelt) {
  InjectionRig rig([](ScriptedPort&) {}, {1000, Clock::Manual});
  rig.host->run(400);
  for (int swap = 0; swap < 1000; ++swap) {
    ASSERT_TRUE(rig.host->load(ball(45 + swap % 30)).empty());
    rig.host->run(swap % 40);
    if (swap % 8 == 0) rig.host->snapshot();
  }
  for (int tick = 0; tick < 200; ++tick) rig.host->snapshot(), rig.host->run(5);
  EXPECT_EQ(rig.host->snapshot().revision, 1001U);
  double largest_N = 0.0;
  for (std::size_t i = 1; i < rig.seen.forces.size(); ++i)
    largest_N = std::max(largest_N, (rig.seen.forces[i] - rig.seen.forces[i - 1]).norm());
  EXPECT_LE(largest_N, 0.88 / 50 + 1e-9);  // the release of the greatest force there is
  EXPECT_FALSE(rig.host->takeFault());
}

TEST(FaultReport, HoldsTheLastSecondUpToTheTickThatFoundIt) {
  InjectionRig rig([](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample& sample) {
      if (read == 2500) sample.q_rad[2] = kNotANumber;
      return true;
    };
  });
  rig.host->run(3000);
  const std::optional<FaultReport> report = rig.host->takeFault();
  ASSERT_TRUE(report);
  ASSERT_EQ(report->last_second.size(), 1000U);
  EXPECT_EQ(report->last_second.back().tick, 2500);
  EXPECT_EQ(report->last_second.back().fault, FaultKind::NotFinite);
  for (std::size_t i = 0; i < 1000; ++i) ASSERT_EQ(report->last_second[i].tick, static_cast<std::int64_t>(1501 + i));
  EXPECT_EQ(report->tick, 2500);
  EXPECT_EQ(report->fault.kind, FaultKind::NotFinite);
  EXPECT_EQ(report->scene.title, "Ball");
  EXPECT_EQ(report->rate_hz, 1000);
  EXPECT_FALSE(rig.host->takeFault()) << "told once";
}

TEST(FaultReport, AnEarlyFaultHoldsWhatThereIs) {
  InjectionRig rig([](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample& sample) {
      if (read == 5) sample.q_rad[2] = kNotANumber;
      return true;
    };
  });
  rig.host->run(10);
  const std::optional<FaultReport> report = rig.host->takeFault();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->last_second.size(), 5U);
}

TEST(FaultReport, EachOfThreeWaitsToBeFetchedAndTheServoGoesOnWithoutThem) {
  InjectionRig rig([](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample& sample) {
      if (read % 100 == 0) sample.q_rad[2] = kNotANumber;
      return true;
    };
  });
  for (int fault = 0; fault < 6; ++fault) {
    rig.host->run(100);
    rig.host->start();
  }
  for (const std::int64_t tick : {100, 200, 300}) {
    const std::optional<FaultReport> report = rig.host->takeFault();
    ASSERT_TRUE(report);
    EXPECT_EQ(report->tick, tick);
  }
  EXPECT_FALSE(rig.host->takeFault());
  rig.host->run(100);
  ASSERT_TRUE(rig.host->takeFault()) << "there is room again";
}

TEST(HoldToRun, PushesOnlyWhileTheButtonIsHeld) {
  InjectionRig rig([](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample& sample) {
      sample.buttons = read >= 500 && read < 1000 ? 1U : 2U;  // the other button does not count
      return true;
    };
  });
  rig.host->setHoldToRun(true);
  EXPECT_TRUE(rig.host->holdToRun());
  rig.host->run(499);
  EXPECT_EQ(rig.force_N(), 0.0);
  EXPECT_TRUE(rig.host->snapshot().waits_for_button);
  rig.host->run(400);
  EXPECT_NEAR(rig.force_N(), 0.5, 1e-9);
  EXPECT_FALSE(rig.host->snapshot().waits_for_button);
  rig.host->run(101 + 60);
  EXPECT_EQ(rig.force_N(), 0.0);
  rig.host->setHoldToRun(false);
  rig.host->run(400);
  EXPECT_NEAR(rig.force_N(), 0.5, 1e-9);
}

}  // namespace underact::servo
