#include "core/servo/check.h"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <thread>

#include "core/scene/compile.h"
#include "core/servo/cpu_load.h"
#include "tests/core/servo/scripted_port.h"

namespace underact::servo {
namespace {

using test::ScriptedPort;

constexpr system::SchedulingRequest kPlainScheduling{.method = system::SchedulingMethod::Normal, .lock_memory = false};

tick::TickProgram sphere() {
  scene::Description scene;
  scene.title = "Sphere";
  scene.control.gains.kp_N_per_mm.setConstant(0.05);
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 50.0}, target::Side::Both, {}, {}});
  return scene::compile(scene).value();
}

bool goOn(double /*share*/) {
  return true;
}

void expectInOrder(const Percentiles& values) {
  EXPECT_GT(values.p50_us, 0.0);
  EXPECT_LE(values.p50_us, values.p99_us);
  EXPECT_LE(values.p99_us, values.p999_us);
  EXPECT_LE(values.p999_us, values.max_us);
}

/// A scripted port that is no simulation, and the largest force it was ever sent.
class RealPort final : public DevicePort {
 public:
  bool read(arm::Sample& sample) noexcept override { return port_.read(sample); }
  void write(const safety::GatedForce& force) noexcept override {
    max_N = std::max(max_N, force.f_T_W().norm());
    port_.write(force);
  }
  void cut() noexcept override { port_.cut(); }
  DeviceInfo info() const override { return {"Scripted", false, false}; }
  ScriptedPort::Seen seen;
  double max_N = 0.0;

 private:
  ScriptedPort port_{seen};
};

}  // namespace

TEST(CheckServo, MeasuresABareLoopAndTheServoInTurnAndLeavesTheArmAtZeroForce) {
  ScriptedPort::Seen seen;
  ScriptedPort port(seen, 100'000);
  double last_share = 0.0;
  const CheckResult result =
      checkServo(port, sphere(), {.seconds = 2, .scheduling = kPlainScheduling}, [&](double share) {
        EXPECT_GE(share, last_share);
        EXPECT_LE(share, 1.0);
        last_share = share;
        return true;
      });
  EXPECT_EQ(last_share, 1.0);
  expectInOrder(result.floor);
  expectInOrder(result.servo);
  expectInOrder(result.tick_time);
  EXPECT_GE(result.seconds, 2.0);
  EXPECT_GT(result.ticks, 0);
  EXPECT_EQ(result.scheduling.name, "normal");
  EXPECT_EQ(std::accumulate(result.late.by_cause.begin(), result.late.by_cause.end(), std::int64_t{0}),
            result.late.total);
  EXPECT_EQ(seen.last_size_N, 0.0);
  double max_N = 0.0;
  for (const Vec3& force : seen.forces) max_N = std::max(max_N, force.norm());
  EXPECT_GT(max_N, 0.0);  // the ticks that were measured had work to do
}

TEST(CheckServo, TicksOnlyInItsOwnTurns) {
  ScriptedPort::Seen seen;
  ScriptedPort port(seen);
  std::int64_t first = -1, last = -1;  // writes in the bare loop's turn, which begins
  checkServo(port, sphere(), {.seconds = 4, .scheduling = kPlainScheduling}, [&](double share) {
    if (share < 0.25) last = seen.writes;
    if (first < 0) first = last;
    return share < 0.25;
  });
  EXPECT_LE(last - first, 2);  // a tick that was under way when the servo was told to rest, and its zero force
}

TEST(CheckServo, AnArmThatIsNoSimulationIsNotPushed) {
  RealPort port;
  const CheckResult result = checkServo(port, sphere(), {.seconds = 1, .scheduling = kPlainScheduling}, goOn);
  EXPECT_GT(result.ticks, 0);
  EXPECT_GT(port.seen.writes, 0);
  EXPECT_EQ(port.max_N, 0.0);
}

TEST(CheckServo, EndsWhenItIsToldToWithWhatItHas) {
  ScriptedPort::Seen seen;
  ScriptedPort port(seen);
  int calls = 0;
  const CheckResult result = checkServo(port, sphere(), {.seconds = 3600, .scheduling = kPlainScheduling},
                                        [&](double) { return ++calls < 3; });
  EXPECT_EQ(calls, 3);
  EXPECT_LT(result.seconds, 3600.0);
  EXPECT_GT(result.seconds, 0.0);
}

TEST(CheckServo, GoesOnThroughAFault) {
  ScriptedPort::Seen seen;
  ScriptedPort port(seen);
  port.spoil = [](std::int64_t read, arm::Sample& sample) {
    if (read == 50) sample.q_rad[1] = kNotANumber;
    return true;
  };
  const CheckResult result = checkServo(port, sphere(), {.seconds = 2, .scheduling = kPlainScheduling}, goOn);
  EXPECT_GT(result.ticks, 50);
}

TEST(CheckServo, UnderLoadItStillEnds) {
  ScriptedPort::Seen seen;
  ScriptedPort port(seen);
  const CheckResult result =
      checkServo(port, sphere(), {.seconds = 1, .load = true, .scheduling = kPlainScheduling}, goOn);
  EXPECT_GT(result.ticks, 0);
}

TEST(CpuLoad, WorksUntilItsEnd) {
  const CpuLoad busy;
  while (busy.rounds() < 2) std::this_thread::yield();
}

}  // namespace underact::servo
