#include "device/remote/arm_side.h"

#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <optional>

#include "core/arm/forward.h"
#include "core/sim/hand_script.h"
#include "device/simulated_arm.h"
#include "tests/support/arm_double.h"
#include "tests/support/property.h"

namespace underact::device::remote {
namespace {

constexpr const char* kPreset = "touch-measured";

/// The simulated arm without encoders and friction, and what it gives to the hand that holds it, by its true places.
class Watched final : public servo::DevicePort {
 public:
  explicit Watched(const char* hand) : arm_(optionsFor()) { arm_.follow(sim::builtInHand(hand, 1).value()); }
  double given_J() const { return given_J_; }
  double max_given_J = -1.0;
  bool read(arm::Sample& sample) noexcept override {
    const bool has = arm_.read(sample);
    const Vec3 p_WT = arm::tipPosition(arm::findPreset(kPreset)->geometry, sample.q_rad);
    if (begun_) given_J_ += f_T_W_.dot(p_WT - p_WT_);
    max_given_J = std::max(max_given_J, given_J_);
    p_WT_ = p_WT;
    begun_ = true;
    return has;
  }
  void write(const safety::GatedForce& force) noexcept override {
    f_T_W_ = force.f_T_W();
    arm_.write(force);
  }
  void cut() noexcept override { arm_.cut(); }
  servo::DeviceInfo info() const override { return arm_.info(); }

 private:
  static SimulatedArm::Options optionsFor() {
    SimulatedArm::Options options;
    options.arm = *arm::findPreset(kPreset);
    options.model = *sim::findArmModel("ideal");
    return options;
  }
  SimulatedArm arm_;
  Vec3 p_WT_ = Vec3::Zero(), f_T_W_ = Vec3::Zero();
  double given_J_ = 0.0;
  bool begun_ = false;
};

/// A line of so many ticks, and up to jitter more, that keeps the order; only the newest of what is due comes out.
template <class What>
class Line {
 public:
  Line(int delay, int jitter, std::uint64_t seed) : delay_(delay), jitter_(jitter), random_(test::Seed{seed}) {}
  void put(std::int64_t tick, const What& what) {
    std::int64_t due = tick + delay_ + static_cast<std::int64_t>(random_.below(static_cast<std::size_t>(jitter_) + 1));
    if (!under_way_.empty()) due = std::max(due, under_way_.back().first);
    under_way_.push_back({due, what});
  }
  std::optional<What> take(std::int64_t tick) {
    std::optional<What> newest;
    for (; !under_way_.empty() && under_way_.front().first <= tick; under_way_.pop_front())
      newest = under_way_.front().second;
    return newest;
  }

 private:
  int delay_, jitter_;
  test::Random random_;
  std::deque<std::pair<std::int64_t, What>> under_way_;
};

struct Trial {
  int delay_ms = 0, jitter_ms = 0;  // each way
  double stiffness_N_per_m = 1000.0;
  const char* hand = "probe";
  bool is_passive = true;
};

ArmSide::Options optionsFor(bool is_passive, const char* preset = kPreset) {
  ArmSide::Options options = optionsOf(*arm::findPreset(preset), {}, 1000).value();
  options.allows_force = true;
  options.is_passive = is_passive;
  options.counts_time = true;
  return options;
}

/// 10 s of a hand at a ball of 40 mm that is felt from afar: the most that the arm has given away, J.
double maxGiven_J(const Trial& trial) {
  Watched arm(trial.hand);
  system::Doorbell bell;
  ArmSide side(arm, optionsFor(trial.is_passive), bell);
  side.seat(true);
  Line<SampleMessage> out(trial.delay_ms, trial.jitter_ms, 1);
  Line<ForceMessage> back(trial.delay_ms, trial.jitter_ms, 2);
  std::uint64_t number = 0;
  SampleMessage last;
  for (std::int64_t tick = 0; tick < 10'000; ++tick) {
    side.tick();
    out.put(tick, side.shown().sample);
    if (const auto sample = out.take(tick)) last = *sample;
    const Vec3 p_WT = arm::tipPosition(arm::findPreset(kPreset)->geometry, last.sample.q_rad);
    const double deep_m = 0.04 - p_WT.norm();
    const Vec3 f_T_W =
        last.sequence > 0 ? Vec3(trial.stiffness_N_per_m * deep_m * p_WT.normalized()) : Vec3(Vec3::Zero());
    back.put(tick, {++number, last.sequence, f_T_W, true});
    if (const auto force = back.take(tick)) side.take(*force);
  }
  return arm.max_given_J;
}

/// What was lent in those 10 s, and what a tick of a stab gives away before it is seen: 1 mm of 0.88 N, twice.
constexpr double kPassive_J = kLent_J + 10.0 * kLentAgain_W + 0.002;

/// A side with an arm whose motors can be seen; a far program that answers each sample with 0.5 N along x.
struct Rig {
  explicit Rig(ArmSide::Options options = optionsFor(false, "omni-thesis")) : side(port, options, bell) {
    arm.countTime(1'000'000);
    side.seat(true);
  }
  void answer(const Vec3& f_T_W = Vec3(0.5, 0.0, 0.0), std::uint64_t late = 0) {
    side.take({++number, side.shown().sample.sequence - late, f_T_W, true});
  }
  /// Ticks that are answered, until the soft start is over.
  void push() {
    for (int tick = 0; tick < 400; ++tick) {
      advance();
      answer();
    }
    advance();
    answer();
  }
  void advance() { side.tick(); }
  test::ArmDouble arm;
  test::ArmDouble::Port port{arm};
  system::Doorbell bell;
  ArmSide side;
  std::uint64_t number = 0;
};

std::atomic<std::int64_t> side_slept_ns{0};
std::int64_t sideWithSleep_ns() noexcept {
  return system::monotonicNow_ns() + side_slept_ns;
}

}  // namespace

TEST(RemoteArmSide, AWallThatIsFeltLateStaysPassiveWithTheControllerAndOnlyWithIt) {
  for (const char* const hand : {"still", "sweep", "probe", "tremor", "stab"}) {
    for (const double stiffness_N_per_m : {200.0, 1000.0, 4000.0}) {
      for (const int delay_ms : {5, 10, 20, 50}) {
        const double given_J = maxGiven_J({delay_ms, 0, stiffness_N_per_m, hand, true});
        EXPECT_LE(given_J, kPassive_J) << hand << ", " << stiffness_N_per_m << " N/m, " << delay_ms << " ms";
      }
    }
  }
  for (const int delay_ms : {5, 10, 20, 50})
    EXPECT_GT(maxGiven_J({delay_ms, 0, 1000.0, "stab", false}), 10.0 * kPassive_J) << delay_ms << " ms";
}

TEST(RemoteArmSide, SoItDoesWhereTheDelayChanges) {
  for (const char* const hand : {"sweep", "probe", "stab"}) {
    for (const int delay_ms : {5, 20, 50}) {
      EXPECT_LE(maxGiven_J({delay_ms, 4, 1000.0, hand, true}), kPassive_J) << hand << ", " << delay_ms << " ms";
    }
    EXPECT_GT(maxGiven_J({10, 4, 4000.0, hand, false}), kPassive_J) << hand;
  }
}

TEST(RemoteArmSide, PassesAForceOnAndEndsItWhereNoneComes) {
  Rig rig;
  rig.push();
  EXPECT_NEAR(rig.arm.force_N().x(), 0.5, 1e-9);
  const std::int64_t before = rig.arm.pushes();
  rig.advance();  // the last that was answered
  for (int tick = 0; tick < 50; ++tick) rig.advance();
  EXPECT_EQ(rig.arm.pushes() - before, kQuietPeriods);
  EXPECT_LT(rig.arm.pushes() - before, 5) << "and one may be under way: five in all, as the guide says";
  EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero()));
  EXPECT_EQ(rig.side.shown().pauses, 1);
  EXPECT_EQ(rig.side.shown().max_unfresh, kQuietPeriods - 1);
  rig.answer();
  rig.advance();
  EXPECT_LT(rig.arm.force_N().x(), 0.01) << "a soft start";
  rig.push();
  EXPECT_NEAR(rig.arm.force_N().x(), 0.5, 1e-9);
}

TEST(RemoteArmSide, AForceForAnOldSampleOrForOneThatIsYetToComeIsNone) {
  for (const std::uint64_t late : {std::uint64_t{200}, std::uint64_t{0} - 10}) {
    Rig rig;
    rig.push();
    for (int tick = 0; tick < 3; ++tick) {
      rig.answer(Vec3(0.5, 0.0, 0.0), late);
      rig.advance();
    }
    EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero())) << late;
  }
  Rig rig;
  rig.push();
  rig.answer(Vec3(0.5, 0.0, 0.0), 100);
  rig.advance();
  EXPECT_NEAR(rig.arm.force_N().x(), 0.5, 1e-9) << "0.1 s are borne";
}

TEST(RemoteArmSide, PushesForWhoHasTheArmAndForNobodyElse) {
  Rig rig;
  rig.push();
  rig.side.seat(false);
  rig.advance();
  EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero()));
  for (int tick = 0; tick < 10; ++tick) {
    rig.answer();
    rig.advance();
  }
  EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero()));
  rig.answer();
  rig.side.seat(true);
  rig.advance();
  EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero())) << "that was the last one's";
}

TEST(RemoteArmSide, WithoutForceAllowedItNeverPushes) {
  ArmSide::Options options = optionsFor(false, "omni-thesis");
  options.allows_force = false;
  Rig rig(options);
  rig.push();
  EXPECT_EQ(rig.arm.pushes(), 0);
  EXPECT_TRUE(rig.side.shown().sample.has_sample);
}

TEST(RemoteArmSide, NoForceGetsAroundTheGate) {
  Rig rig;
  for (int tick = 0; tick < 600; ++tick) {
    rig.advance();
    rig.answer(Vec3(1e9, 0.0, 0.0));
    ASSERT_LE(rig.arm.force_N().norm(), 0.88 * (1.0 + 1e-12));
    ASSERT_LE(rig.arm.force_N().norm(), 0.88 * (tick + 1) / 300.0 + 1e-3) << "a soft start";
  }
  EXPECT_NEAR(rig.arm.force_N().norm(), 0.88, 1e-9);
  rig.arm.placeTip(Vec3(0.05, 0.0, 0.06));  // 50 mm in a period: no hand
  rig.advance();
  EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero()));
  EXPECT_EQ(rig.side.shown().fault.kind, FaultKind::TooFast);
  rig.push();
  EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero())) << "a fault lasts";
  rig.answer(Vec3::Zero());
  rig.advance();
  EXPECT_EQ(rig.side.shown().fault.kind, FaultKind::None) << "until the far servo lets go, too";
  rig.push();
  EXPECT_NEAR(rig.arm.force_N().x(), 0.5, 1e-9);
}

// As at a servo of this machine's own: see tests/core/servo/clocks_test.cpp.
TEST(RemoteArmSide, AClockOfTheArmThatIsNoneEndsTheForceUntilTheFarServoLetsGo) {
  for (const std::int64_t step_ns : {10'000, 500'000, 2'000'000, 200'000'000}) {
    Rig rig;
    rig.push();
    ASSERT_NEAR(rig.arm.force_N().x(), 0.5, 1e-9);
    rig.arm.countTime(step_ns);
    rig.push();
    EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero())) << step_ns;
    EXPECT_EQ(rig.side.shown().fault.kind, FaultKind::OddClock) << step_ns;
    rig.arm.countTime(1'000'000);
    rig.push();
    EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero())) << "a fault lasts";
    rig.answer(Vec3::Zero());
    rig.advance();
    rig.push();
    EXPECT_NEAR(rig.arm.force_N().x(), 0.5, 1e-9);
  }
}

TEST(RemoteArmSide, AMachineThatSleptPushesOnlyWhenTheFarServoHasLetGo) {
  ArmSide::Options options = optionsFor(false, "omni-thesis");
  options.counts_time = false;
  options.clocks.with_sleep_ns = sideWithSleep_ns;
  Rig rig(options);
  rig.arm.countTime(0);  // by this machine's clock, as its ticks are
  rig.push();
  ASSERT_GT(rig.arm.force_N().x(), 0.1);
  side_slept_ns += 3'600'000'000'000;
  rig.advance();
  EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero())) << "no force before the fault";
  EXPECT_EQ(rig.side.shown().fault.kind, FaultKind::Asleep);
  rig.push();
  EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero()));
  rig.answer(Vec3::Zero());
  rig.advance();
  rig.push();
  EXPECT_GT(rig.arm.force_N().x(), 0.1);
}

TEST(RemoteArmSide, AnArmThatGivesNoSampleGetsZero) {
  Rig rig;
  rig.push();
  rig.arm.lose(true);
  rig.advance();
  EXPECT_EQ(rig.arm.force_N(), Vec3(Vec3::Zero()));
  EXPECT_FALSE(rig.side.shown().sample.has_sample);
  rig.arm.lose(false);
  rig.answer();
  rig.advance();
  EXPECT_TRUE(rig.side.shown().sample.has_sample);
  EXPECT_LT(rig.arm.force_N().x(), 0.01) << "a soft start";
}

}  // namespace underact::device::remote
