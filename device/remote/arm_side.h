#pragma once
#include <atomic>
#include <cstdint>

#include "core/arm/preset.h"
#include "core/control/passivity.h"
#include "core/servo/arm_clock_watch.h"
#include "core/servo/device_port.h"
#include "core/servo/sleep_watch.h"
#include "core/servo/slot.h"
#include "core/system/clock.h"
#include "core/system/doorbell.h"
#include "device/remote/message.h"

namespace underact::device::remote {

/// So many periods without a new force, and the arm gets zero: with one that is under way when the line breaks, five
/// forces at most still go out. And so old may the sample be that a force answers: a
/// stick that was felt there a sixth of a second ago is felt as another one.
inline constexpr int kQuietPeriods = 4;
inline constexpr std::int64_t kOldest_ns = 150'000'000;
/// Energy that was put in long ago must not pay for a burst now: no more than this is remembered, what 0.88 N absorb
/// over 57 mm.
inline constexpr double kMaxStored_J = 0.05;
/// A spring that pulls the tip from its position at Start gives out energy that nobody has put in. This much is lent,
/// and again over time: more slowly than the friction of an arm dissipates it (0.26 N at 10 mm/s are 2.6 mW).
inline constexpr double kLent_J = 0.010, kLentAgain_W = 0.001;

/// The tick of a shared arm: reads it, and passes on the force that the remote program asks for, as far as that is
/// fresh, passive and within the gate. Passive: the force is late by the delays of the sample and of the force, so a
/// wall that is passive there generates energy here. It is accounted for at the arm, with each displacement of the tip
/// and the force in effect during it, and the deficit is damped (core/control/passivity). Knows no network.
class ArmSide final : public servo::Ticks {
 public:
  struct Options {
    arm::Geometry geometry;
    arm::JointLimits joint_limits;
    safety::Limits limits;
    std::int64_t period_ns = 1'000'000;
    bool allows_force = false, is_passive = true;
    bool counts_time = false;  // a tick counts as a period, whenever it comes: for ticking faster than real time
    system::Clocks clocks = {};
  };
  /// What a tick saw.
  struct Shown {
    SampleMessage sample;
    Vec3 f_T_W = Vec3::Zero();     // written
    Fault fault;                   // of the gate here
    double energy_J = 0.0;         // put in at the arm and not returned, including what was lent
    std::int64_t pauses = 0;       // times that a force ended because no new one came
    std::int64_t max_unfresh = 0;  // most forces, over all of these, sent after the last one received
  };
  ArmSide(servo::DevicePort& port, const Options& options, system::Doorbell& shown);

  void tick() noexcept UNDERACT_REAL_TIME override;

  // The network's thread.
  void take(const ForceMessage& message);
  /// A program has taken the arm; its history is reset.
  void seat(bool is_taken);
  const Shown& shown() { return shown_.latest(); }
  // Any thread.
  std::int64_t beats() const { return beats_->load(std::memory_order_relaxed); }

  /// Where ticks are counted from now on; no tick is at work. Outlives them.
  void countInto(std::atomic<std::int64_t>& beats) { beats_ = &beats; }

 private:
  struct Came {
    std::uint64_t arrival = 0;
    std::uint32_t seat = 0;
    ForceMessage message;
  };
  bool hears(const Came& came) noexcept UNDERACT_REAL_TIME;
  Fault judge(bool has, double dt_s) const noexcept UNDERACT_REAL_TIME;
  double beginTick() noexcept UNDERACT_REAL_TIME;
  Fault faultOfClocks(bool has) noexcept UNDERACT_REAL_TIME;
  void noticeSleep() noexcept UNDERACT_REAL_TIME;
  Vec3 keepPassive(const Vec3& displacement_T_W, double dt_s, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;
  void reset() noexcept UNDERACT_REAL_TIME;

  servo::DevicePort& port_;
  const Options options_;
  system::Doorbell& bell_;
  servo::Slot<Came> came_;
  servo::Slot<Shown> shown_;
  std::atomic<std::uint32_t> seat_{0};  // counts takings and leavings; odd: taken
  std::atomic<std::int64_t> own_beats_{0};
  std::atomic<std::int64_t>* beats_ = &own_beats_;
  // The network's.
  std::uint64_t arrivals_ = 0;
  // The tick's.
  Shown now_;
  safety::GateState gate_;
  control::EnergyState energy_;
  std::uint64_t arrival_ = 0;
  std::uint32_t seated_ = 0;
  std::int64_t unfresh_ = 0;  // periods since a new force came
  Vec3 p_WT_ = Vec3::Zero();
  arm::JointAngles q_rad_{};
  std::int64_t time_ns_ = 0;
  bool has_last_ = false;
  servo::SleepWatch sleep_;
  servo::ArmClockWatch arm_clock_;
  std::int64_t slept_ns_ = 0;  // not yet reported to a tick
  double since_s_ = 0.0;       // by the time of this computer, since the last good sample
  std::int64_t at_ns_ = 0;     // when this tick began, by the clock of this computer; 0: none did
};

/// The limits of an arm of that preset, as a scene for it has them.
Result<ArmSide::Options> optionsOf(const arm::Preset& preset, const servo::DeviceInfo& info, int rate_hz);

}  // namespace underact::device::remote
