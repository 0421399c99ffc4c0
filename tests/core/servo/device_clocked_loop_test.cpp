#include "core/servo/device_clocked_loop.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/servo/host.h"
#include "core/system/clock.h"
#include "tests/core/servo/scripted_port.h"
#include "tests/support/comes.h"

namespace underact::servo {
namespace {

using namespace std::chrono_literals;
using test::comes;
using test::ScriptedPort;

/// An arm with a scheduler of its own: a thread that ticks at the asked rate, unless the test halts it.
class ClockedPort final : public DevicePort {
 public:
  struct Clock {
    std::atomic<bool> halted{false}, has_one{true};
    std::atomic<int> rate_hz{0}, drives{0}, rate_set_hz{0};
    std::atomic<std::thread::id> thread{}, read_in{};
    std::atomic<std::int64_t> pause_ns{0};  // once, before the next tick
    std::atomic<bool> is_read_hanging{false};
  };
  ClockedPort(ScriptedPort::Seen& seen, Clock& clock) : inner_(seen), clock_(clock) {}
  ~ClockedPort() override { endDrive(); }

  bool read(arm::Sample& sample) noexcept override {
    // Without its clock it has no new sample.
    if (clock_.halted) return false;
    while (clock_.is_read_hanging) std::this_thread::sleep_for(1ms);
    clock_.read_in = std::this_thread::get_id();
    return inner_.read(sample);
  }
  void write(const safety::GatedForce& force) noexcept override { inner_.write(force); }
  void cut() noexcept override { inner_.cut(); }
  Sentence fixedRateReason() const override { return {}; }
  Sentence rateRefusal(int rate_hz) const override { return rate_hz == 300 ? "Not at 300 Hz." : ""; }
  void setRate(int rate_hz) override {
    clock_.rate_set_hz = rate_hz;
    inner_.setRate(rate_hz);
  }
  bool drive(Ticks& ticks, int rate_hz) override {
    if (!clock_.has_one) return false;
    ++clock_.drives;
    clock_.rate_hz = rate_hz;
    ends_ = false;
    thread_ = std::thread([this, &ticks, rate_hz] { run(ticks, rate_hz); });
    return true;
  }
  void endDrive() override {
    ends_ = true;
    if (thread_.joinable()) thread_.join();
  }
  DeviceInfo info() const override { return {"Clocked", true, false}; }

 private:
  void run(Ticks& ticks, int rate_hz) {
    clock_.thread = std::this_thread::get_id();
    while (!ends_) {
      std::this_thread::sleep_for(std::chrono::nanoseconds(1'000'000'000 / rate_hz));
      std::this_thread::sleep_for(std::chrono::nanoseconds(clock_.pause_ns.exchange(0)));
      if (!clock_.halted && !ends_) ticks.tick();
    }
  }
  ScriptedPort inner_;
  Clock& clock_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

scene::Description pull() {
  scene::Description scene;
  scene.title = "Pull";
  scene.constraints.push_back({"point", scene::Point{Vec3(5.0, 0.0, 60.0)}, target::Side::Both, {}, {}});
  return scene;
}

class DrivenServo : public testing::Test {
 protected:
  std::unique_ptr<ClockedPort> port() { return std::make_unique<ClockedPort>(seen, clock); }
  void pushOn(HostOptions options = {.max_late = 1'000'000}) {
    host = std::make_unique<Host>(port(), options);
    ASSERT_TRUE(host->load(pull()).empty());
    host->start();
    host->begin();
    ASSERT_TRUE(comes([this] { return (host->snapshot(), seen.last_size_N > 0.1); }));
  }
  ScriptedPort::Seen seen;
  ClockedPort::Clock clock;
  std::unique_ptr<Host> host;
};

}  // namespace

TEST_F(DrivenServo, TicksInTheThreadOfTheArmAndSaysSo) {
  pushOn();
  EXPECT_EQ(clock.drives, 1);
  EXPECT_EQ(clock.rate_hz, 1000);
  EXPECT_EQ(clock.read_in.load(), clock.thread.load());
  EXPECT_EQ(host->scheduling().name, "by the arm's own clock");
}

TEST_F(DrivenServo, AnArmWithoutAClockIsTickedByTheServosThread) {
  clock.has_one = false;
  pushOn();
  EXPECT_NE(host->scheduling().name, "by the arm's own clock");
}

TEST_F(DrivenServo, ATickIsLateByWhatItCameAfterAPeriod) {
  pushOn();
  host->drain([](const TickRecord&) {});
  clock.pause_ns = 60'000'000;
  TickRecord late;
  ASSERT_TRUE(comes([&] {
    host->drain([&](const TickRecord& row) {
      if (row.lateness_ns > late.lateness_ns) late = row;
    });
    return late.lateness_ns > 50'000'000;
  }));
  EXPECT_GE(late.lateness_ns, 60'000'000) << "the pause came on top of a period";
  EXPECT_NE(late.input & kLate, 0U);
  EXPECT_GT(host->snapshot().late.by_cause[static_cast<std::size_t>(LateCause::Device)], 0);
  EXPECT_GE(host->snapshot().late.left_out, 60);
}

TEST_F(DrivenServo, AtItsEndNoTickIsAtWorkAndZeroIsWritten) {
  pushOn();
  host.reset();
  EXPECT_EQ(seen.last_size_N, 0.0);
  const std::int64_t writes = seen.writes;
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(seen.writes, writes);
}

TEST_F(DrivenServo, RestartedItDrivesAnewAndPushesAfterStart) {
  pushOn();
  ASSERT_TRUE(host->restart().empty());
  EXPECT_EQ(clock.drives, 2);
  const std::int64_t ticks = host->snapshot().ticks;
  ASSERT_TRUE(comes([&] { return host->snapshot().ticks > ticks + 10; }));
  EXPECT_EQ(seen.last_size_N, 0.0) << "nobody said Start";
  host->start();
  EXPECT_TRUE(comes([this] { return (host->snapshot(), seen.last_size_N > 0.1); }));
}

TEST_F(DrivenServo, TakesTheRatesThatTheArmTakes) {
  pushOn();
  const Problems refused = host->setRate(300);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused.front().sentence, "Not at 300 Hz.");
  EXPECT_EQ(clock.drives, 1) << "then nothing was done";
  ASSERT_TRUE(host->setRate(500).empty());
  EXPECT_EQ(clock.rate_set_hz, 500);
  EXPECT_EQ(clock.rate_hz, 500);
  EXPECT_TRUE(comes([this] { return (host->snapshot(), seen.last_size_N > 0.1); }));
}

TEST_F(DrivenServo, WhereTheArmsClockStopsTheForceIsZeroAndTheFaultIsSeen) {
  pushOn();
  clock.halted = true;
  ASSERT_TRUE(comes([this] { return host->snapshot().mode == Mode::Faulted; }));
  EXPECT_EQ(host->snapshot().report.fault.kind, FaultKind::StoodStill);
  EXPECT_EQ(seen.last_size_N, 0.0);
  const std::optional<FaultReport> report = host->takeFault();
  ASSERT_TRUE(report);
  EXPECT_GE(report->fault.seen, 0.1) << "the watchdog's limit, s";
  clock.halted = false;
  const std::int64_t ticks = host->snapshot().ticks;
  ASSERT_TRUE(comes([&] { return host->snapshot().ticks > ticks + 20; }));
  EXPECT_EQ(seen.last_size_N, 0.0) << "it takes a Start";
  host->start();
  EXPECT_TRUE(comes([this] { return (host->snapshot(), seen.last_size_N > 0.1); }));
}

TEST_F(DrivenServo, WithoutAWatchdogAStoppedClockIsAFaultAllTheSame) {
  pushOn({.watchdog_s = 0.0, .max_late = 1'000'000});
  clock.halted = true;
  ASSERT_TRUE(comes([this] { return host->snapshot().mode == Mode::Faulted; }));
  EXPECT_EQ(host->snapshot().report.fault.kind, FaultKind::NoSample);
}

TEST_F(DrivenServo, WhereATickHangsTheWatchdogCutsTheArm) {
  pushOn();
  clock.is_read_hanging = true;
  EXPECT_TRUE(comes([this] { return seen.cuts > 2; }));
  clock.is_read_hanging = false;
  EXPECT_TRUE(comes([this] { return host->snapshot().mode == Mode::Faulted; }));
}

TEST_F(DrivenServo, CommandsAreTakenUpWhileTheClockStandsStill) {
  pushOn();
  clock.halted = true;
  ASSERT_TRUE(comes([this] { return host->snapshot().mode == Mode::Faulted; }));
  ASSERT_TRUE(host->load(pull()).empty());
  EXPECT_TRUE(comes([this] { return host->snapshot().revision == host->revision(); }));
}

}  // namespace underact::servo
