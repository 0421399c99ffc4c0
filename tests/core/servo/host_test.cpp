#include "core/servo/host.h"

#include <chrono>
#include <cmath>
#include <thread>

#include "core/scene/edit.h"
#include "core/scene/settings.h"
#include "tests/core/servo/scripted_port.h"
#include "tests/support/comes.h"
#include "tests/support/property.h"

namespace underact::servo {
namespace {

using test::ScriptedPort;

scene::Description sphereScene(double radius_mm, double kp_N_per_mm = 0.05) {
  scene::Description scene;
  scene.title = "Sphere";
  scene.control.gains.kp_N_per_mm.setConstant(kp_N_per_mm);
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), radius_mm}, target::Side::Both, {}, {}});
  return scene;
}

struct Rig {
  explicit Rig(std::size_t keep = 100'000, const std::function<void(ScriptedPort&)>& prepare = {}) {
    auto port = std::make_unique<ScriptedPort>(seen, keep);
    if (prepare) prepare(*port);
    host = std::make_unique<Host>(std::move(port), HostOptions{1000, Clock::Manual});
  }
  ScriptedPort::Seen seen;
  std::unique_ptr<Host> host;
};

double largestStep(const std::vector<Vec3>& forces) {
  double largest_N = 0.0;
  for (std::size_t i = 1; i < forces.size(); ++i) largest_N = std::max(largest_N, (forces[i] - forces[i - 1]).norm());
  return largest_N;
}

}  // namespace

TEST(Host, PushesOnlyBetweenStartAndStop) {
  Rig rig;
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  rig.host->run(100);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Idle);
  rig.host->start();
  rig.host->run(500);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Running);
  EXPECT_NEAR(rig.seen.last_size_N, 0.5, 1e-9);  // 10 mm outside, 0.05 N/mm; the joints cost 1e-13 m
  rig.host->stop();
  rig.host->run(10);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Stopping);
  rig.host->run(90);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Idle);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
}

TEST(Host, WhoeverCountsTheStopsUpStopsItPastTheQueueAndPastEarlierStarts) {
  Rig rig;
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  rig.host->start();
  rig.host->push({0.1, 0.0, 0.0}, 1000);
  rig.host->run(500);
  ASSERT_TRUE(rig.host->running());
  for (int more = 0; more < 500; ++more) rig.host->start();  // what the queue has no room for waits at the host
  ++rig.host->stops();
  EXPECT_FALSE(rig.host->running());
  rig.host->run(60);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Idle);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  for (int tick = 0; tick < 100; ++tick) {
    rig.host->snapshot();  // sends what waits
    rig.host->run(10);
  }
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Idle) << "a Start from before the stop came into effect";
  rig.host->start();
  rig.host->run(500);
  EXPECT_TRUE(rig.host->running());
  EXPECT_NEAR(rig.seen.last_size_N, 0.5, 1e-9) << "the client's force outlived the stop";
}

TEST(Host, AnotherThreadStopsItWithinTwoTicksWhileItsOwnIsBusy) {
  ScriptedPort::Seen seen;
  Host host(std::make_unique<ScriptedPort>(seen), HostOptions{1000, Clock::Thread});
  ASSERT_TRUE(host.load(sphereScene(50)).empty());
  host.start();
  host.begin();
  ASSERT_TRUE(test::comes([&] { return seen.last_size_N > 0.49; }));
  std::atomic<std::uint64_t>& stops = host.stops();
  std::thread([&stops] { ++stops; }).join();
  EXPECT_TRUE(test::comes([&] { return seen.last_size_N == 0.0; }));  // this thread never calls the host meanwhile
  EXPECT_FALSE(host.running());
}

TEST(Host, AWindowThatIsBusyIsAFaultWhereItPushesAndNothingElsewhere) {
  Rig rig;
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  rig.host->reportBusyWindow(700'000'000);
  rig.host->run(10);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Idle);
  rig.host->start();
  rig.host->run(500);
  ASSERT_EQ(rig.host->snapshot().mode, Mode::Running) << "an earlier report was kept for later";
  rig.host->reportBusyWindow(700'000'000);
  rig.host->run(1);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Faulted);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  EXPECT_EQ(describe(rig.host->takeFault()->fault),
            "The window was too busy to hear Stop for 0.7 s. Force is off. Press Start to continue.");
}

TEST(Host, AShareOfTheForceIsTheMostThatIsSentFromTheNextTickOnWhateverSceneComes) {
  Rig rig;
  ASSERT_TRUE(rig.host->load(sphereScene(50, 0.5)).empty());  // 5 N are asked for
  rig.host->start();
  rig.host->run(500);
  const double whole_N = rig.seen.last_size_N;
  EXPECT_NEAR(whole_N, 0.88, 1e-9);
  ASSERT_TRUE(rig.host->setForceShare(0.5).empty());
  EXPECT_EQ(rig.host->forceShare(), 0.5);
  rig.host->run(1);
  EXPECT_NEAR(rig.seen.last_size_N, 0.5 * whole_N, 1e-9);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Running);  // it goes on pushing
  const std::size_t before = rig.seen.forces.size();
  ASSERT_TRUE(rig.host->load(sphereScene(20, 0.5)).empty());
  rig.host->run(1000);
  for (std::size_t tick = before; tick < rig.seen.forces.size(); ++tick)
    ASSERT_LE(rig.seen.forces[tick].norm(), 0.5 * whole_N + 1e-9);
  EXPECT_NEAR(rig.seen.last_size_N, 0.5 * whole_N, 1e-9);
  ASSERT_TRUE(rig.host->setForceShare(1.0).empty());
  rig.host->run(10);
  EXPECT_NEAR(rig.seen.last_size_N, whole_N, 1e-9);
}

TEST(Host, AShareThatIsNoneIsRefused) {
  Rig rig;
  for (const double share : {-0.1, 1.1, std::nan("")}) EXPECT_FALSE(rig.host->setForceShare(share).empty()) << share;
  EXPECT_EQ(rig.host->forceShare(), 1.0);
  EXPECT_EQ(rig.host->revision(), 0u);  // and no scene has come by it
}

TEST(Host, AGainReachesTheNextTickAndFadesInWithoutAStep) {
  Rig rig;
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  rig.host->start();
  rig.host->run(1000);
  scene::Control control = rig.host->scene().control;
  control.gains.kp_N_per_mm.setConstant(0.06);
  ASSERT_TRUE(rig.host->edit(withControl(rig.host->scene(), 0, control)).empty());
  rig.host->run(1);
  EXPECT_EQ(rig.host->snapshot().revision, rig.host->revision());
  EXPECT_NEAR(rig.seen.last_size_N, 0.5, 1e-9);
  rig.host->run(20);  // backward Euler: what is left of the step is (20 ms / (20 ms + 1 ms))^20 of it
  EXPECT_NEAR(rig.seen.last_size_N, 0.6 - 0.1 * std::pow(20.0 / 21.0, 20), 1e-9);
  rig.host->run(500);
  EXPECT_NEAR(rig.seen.last_size_N, 0.6, 1e-9);
  EXPECT_LE(largestStep(rig.seen.forces), 0.1 / 21 + 1e-9);
}

TEST(Host, AnotherLawTakesOverWithoutAStep) {  // what the integral held is handed over, not dropped
  Rig rig;
  scene::Description scene = sphereScene(50);
  scene.control.law = scene::LawType::PID;
  scene.control.gains.ki_N_per_mm_s.setConstant(0.01);
  ASSERT_TRUE(rig.host->load(scene).empty());
  rig.host->start();
  rig.host->run(2000);
  const double before_N = rig.seen.last_size_N;
  ASSERT_GT(before_N, 0.65);
  scene.control.law = scene::LawType::PD;
  scene.control.gains.ki_N_per_mm_s.setZero();
  ASSERT_TRUE(rig.host->edit(scene).empty());
  rig.host->run(1);
  EXPECT_NEAR(rig.seen.last_size_N, before_N, 1e-9);
  rig.host->run(500);
  EXPECT_NEAR(rig.seen.last_size_N, 0.5, 1e-9);
  EXPECT_LE(largestStep(rig.seen.forces), before_N / 21);
}

TEST(Host, AGainChangeKeepsTheIntegral) {
  Rig rig;
  scene::Description scene = sphereScene(50);
  scene.control.law = scene::LawType::PID;
  scene.control.gains.ki_N_per_mm_s.setConstant(0.01);
  ASSERT_TRUE(rig.host->load(scene).empty());
  rig.host->start();
  rig.host->run(2000);
  const double before_N = rig.seen.last_size_N;
  ASSERT_GT(before_N, 0.55);
  scene.control.gains.ki_N_per_mm_s.setConstant(0.02);
  ASSERT_TRUE(rig.host->edit(scene).empty());
  rig.host->run(1);
  EXPECT_NEAR(rig.seen.last_size_N, before_N, 0.02 * 10 * 1e-3 * 1.01);  // one tick of the new integral, no more
}

TEST(Host, ASceneSwapGoesThroughZeroForceWithoutAJump) {
  Rig rig;
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  rig.host->start();
  rig.host->run(1000);
  ASSERT_TRUE(rig.host->load(sphereScene(70)).empty());  // pulls the other way
  rig.host->run(1000);
  EXPECT_EQ(rig.host->snapshot().revision, 2U);
  EXPECT_NEAR(rig.seen.forces.back().z(), 0.5, 1e-9);
  bool was_zero = false;
  for (std::size_t i = 1000; i < rig.seen.forces.size(); ++i) was_zero |= rig.seen.forces[i].isZero();
  EXPECT_TRUE(was_zero);
  EXPECT_LE(largestStep(rig.seen.forces), 0.5 * 0.001 / 0.05 + 1e-9);  // the release: the whole force in fall_s
}

TEST(Host, TheLastOfManySwapsWinsAndNoneIsLost) {
  Rig rig;
  rig.host->start();
  for (int i = 0; i < 500; ++i) ASSERT_TRUE(rig.host->load(sphereScene(30 + i % 40)).empty());
  for (int i = 0; i < 300; ++i) {
    rig.host->snapshot();  // what found no room goes out now
    rig.host->run(5);
  }
  EXPECT_EQ(rig.host->snapshot().revision, 500U);
}

TEST(Host, ABrokenEditIsRefusedAndTheOldOneStays) {
  Rig rig;
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  scene::Control control = rig.host->scene().control;
  control.gains.kp_N_per_mm = Vec3(0.0, 0.5, 0.5);  // a zero gain has no metric on a sphere
  EXPECT_FALSE(rig.host->edit(withControl(rig.host->scene(), 0, control)).empty());
  rig.host->run(1);
  EXPECT_EQ(rig.host->snapshot().revision, 1U);
  EXPECT_EQ(rig.host->scene().control.gains.kp_N_per_mm, Vec3::Constant(0.05));
}

TEST(Host, ANotANumberStopsTheServoUntilItIsStartedAgain) {
  Rig rig(10'000, [](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample& sample) {
      if (read == 700) sample.q_rad[1] = kNotANumber;
      return true;
    };
  });
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  rig.host->start();
  rig.host->run(699);
  ASSERT_GT(rig.seen.last_size_N, 0.4);
  rig.host->run(1);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  rig.host->run(500);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Faulted);
  EXPECT_EQ(rig.host->snapshot().report.fault.kind, FaultKind::NotFinite);
  EXPECT_FALSE(rig.host->running());
  rig.host->start();
  rig.host->run(500);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Running);
  EXPECT_NEAR(rig.seen.last_size_N, 0.5, 1e-9);
}

TEST(Host, AnArmThatStopsAnsweringGetsZeroAtOnceAndAFaultAfterTwentyTicks) {
  Rig rig(10'000, [](ScriptedPort& port) {
    port.spoil = [](std::int64_t read, arm::Sample&) { return read < 700 || read >= 800; };
  });
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  rig.host->start();
  rig.host->run(700);
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
  EXPECT_NE(rig.host->snapshot().mode, Mode::Faulted);
  rig.host->run(20);
  EXPECT_EQ(rig.host->snapshot().mode, Mode::Faulted);
  EXPECT_EQ(rig.host->snapshot().report.fault.kind, FaultKind::NoSample);
  rig.host->run(200);  // answering again: it still takes a Start
  EXPECT_EQ(rig.seen.last_size_N, 0.0);
}

TEST(Host, DrainGivesEveryTickOnceAndInOrderAndCountsWhatFoundNoRoom) {
  Rig rig(0);
  rig.host->run(1000);
  std::int64_t next = 1;
  rig.host->drain([&](const TickRecord& record) { EXPECT_EQ(record.tick, next++); });
  EXPECT_EQ(next, 1001);
  rig.host->run(40'000);
  EXPECT_GT(rig.host->snapshot().dropped, 0);
  std::int64_t rows = 0;
  rig.host->drain([&](const TickRecord&) { ++rows; });
  EXPECT_EQ(rows + rig.host->snapshot().dropped, 40'000);
}

TEST(Host, AChangeOfSpaceIsRampedLikeAScene) {
  Rig rig;
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  rig.host->start();
  rig.host->run(1000);
  scene::Control control = rig.host->scene().control;
  control.space = tick::Space::Joint;
  ASSERT_TRUE(rig.host->edit(withControl(rig.host->scene(), 0, control)).empty());
  rig.host->run(1);
  EXPECT_EQ(rig.host->snapshot().revision, rig.host->revision() - 1);  // not before the force is zero
  rig.host->run(500);
  EXPECT_EQ(rig.host->snapshot().revision, rig.host->revision());
  EXPECT_GT(rig.seen.last_size_N, 0.1);
  EXPECT_LE(largestStep(rig.seen.forces), 0.5 / 50 + 1e-6);  // the ramp down: 0.5 N in 50 ticks
}

scene::Description ringScene(double t) {
  scene::Description scene;
  scene.title = "Ring";
  scene.control.law = scene::LawType::PD;
  scene.control.gains.kp_N_per_mm.setConstant(0.01);
  scene.control.gains.kd_N_s_per_mm.setConstant(0.002);
  scene::Constraint rim{"rim", scene::Circle{Vec3::Zero(), Vec3::UnitX(), 50}, target::Side::Both, {}, {}};
  rim.influence = scene::Influence{t, scene::StylusAxis::PlusZ, 5.0};
  scene.constraints.push_back(rim);
  return scene;
}

TEST(Host, AnInfluenceReachesTheNextTickAndTheTargetsWayIsNoRateOfTheError) {
  Rig rig;
  ASSERT_TRUE(rig.host->load(ringScene(1.0)).empty());
  rig.host->start();
  rig.host->run(1000);
  const Vec3 before_W = rig.host->snapshot().report.held[0].p_WP;
  const Vec3 force_before = rig.host->snapshot().report.f_T_W;
  ASSERT_TRUE(rig.host->edit(ringScene(0.8)).empty());
  rig.host->run(1);
  EXPECT_EQ(rig.host->snapshot().revision, 2U);
  const Vec3 way_W = rig.host->snapshot().report.held[0].p_WP - before_W;
  ASSERT_GT(way_W.norm(), 1e-3);
  EXPECT_LT((rig.host->snapshot().report.f_T_W - force_before).norm(), 1e-12);  // and no step
  // kp times the way; of kd (2 N s/m) the way in one tick would make some 770 N/m more.
  const Vec3 own_T_W = rig.host->snapshot().report.held[0].f_T_W;
  EXPECT_LT((own_T_W - force_before - 10.0 * way_W).norm(), 0.05 * 10.0 * way_W.norm());
}

TEST(Host, ARowHasTheAnglesOfTheFirstInfluencedTargetThatActs) {
  Rig rig;
  scene::Description scene = ringScene(0.25);
  scene.constraints.insert(scene.constraints.begin(), sphereScene(50).constraints.front());
  ASSERT_TRUE(rig.host->load(scene).empty());
  rig.host->run(1);
  const target::Angles wanted = rig.host->snapshot().report.held[1].angles;
  ASSERT_TRUE(std::isfinite(wanted.alpha_rad));
  std::vector<target::Angles> seen;
  rig.host->drain([&](const TickRecord& record) { seen.push_back(record.angles); });
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].alpha_rad, wanted.alpha_rad);
  EXPECT_EQ(seen[0].beta_rad, wanted.beta_rad);
  EXPECT_EQ(seen[0].theta_rad, wanted.theta_rad);
  ASSERT_TRUE(rig.host->load(sphereScene(50)).empty());
  rig.host->run(1);
  rig.host->drain([&](const TickRecord& record) { EXPECT_TRUE(std::isnan(record.angles.theta_rad)); });
}

TEST(Host, AnInfluenceThatComesOrGoesIsRampedLikeAScene) {
  Rig rig;
  scene::Description scene = ringScene(0.5);
  ASSERT_TRUE(rig.host->load(scene).empty());
  rig.host->start();
  rig.host->run(1000);
  ASSERT_TRUE(rig.host->edit(withValue(scene, "/constraints/0/influence/t", {}).value()).empty());
  rig.host->run(1);
  EXPECT_EQ(rig.host->snapshot().revision, 1U);
  rig.host->run(500);
  EXPECT_EQ(rig.host->snapshot().revision, 2U);
}

TEST(HostThread, TicksByItselfTakesCommandsAndEndsAtZeroForce) {  // under the thread sanitizer: a storm of commands
  ScriptedPort::Seen seen;
  {
    Host host(std::make_unique<ScriptedPort>(seen), HostOptions{2000, Clock::Thread});
    EXPECT_EQ(host.scheduling().name, "not started");
    ASSERT_TRUE(host.load(sphereScene(50)).empty());
    host.start();
    host.begin();
    EXPECT_NE(host.scheduling().name, "not started");
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1500);
    std::int64_t rows = 0;
    for (int i = 0; std::chrono::steady_clock::now() < end; ++i) {
      if (i % 3 == 0) {
        ASSERT_TRUE(host.load(sphereScene(40 + i % 30)).empty());
      } else {
        scene::Control control = host.scene().control;
        control.gains.kp_N_per_mm.setConstant(0.01 + 0.001 * (i % 7));
        ASSERT_TRUE(host.edit(withControl(host.scene(), 0, control)).empty());
      }
      host.drain([&](const TickRecord& record) {
        ASSERT_EQ(record.tick, ++rows);
        ASSERT_GT(record.revision, 0U);  // the scene was there before the first tick
        ASSERT_LE(record.f_sent_T_W.norm(), 0.88 * (1 + 1e-15));
      });
      host.snapshot();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_GT(rows, 100);
    EXPECT_EQ(host.snapshot().dropped, 0);
  }
  EXPECT_EQ(seen.last_size_N, 0.0);
}

TEST(Host, ASnapshotStaysWhatItWasWhateverIsCalledThen) {
  ScriptedPort::Seen seen;
  Host host(std::make_unique<ScriptedPort>(seen), HostOptions{.max_late = 1'000'000});
  ASSERT_TRUE(host.load(sphereScene(50)).empty());
  host.start();
  host.begin();
  ASSERT_TRUE(test::comes([&] { return host.snapshot().mode == Mode::Running; }));
  const Snapshot& kept = host.snapshot();
  const Snapshot copy = kept;
  for (int call = 0; call < 200; ++call) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    (void)host.running();
    ASSERT_TRUE(host.edit(sphereScene(50, 0.02 + 1e-4 * call)).empty());  // asks which scenes are still in effect
    ASSERT_EQ(kept.ticks, copy.ticks);
    ASSERT_EQ(kept.revision, copy.revision);
    ASSERT_EQ(kept.report.sample.time_ns, copy.report.sample.time_ns);
  }
  EXPECT_GT(host.snapshot().ticks, copy.ticks + 50) << "else nothing could have changed it";
}

}  // namespace underact::servo
