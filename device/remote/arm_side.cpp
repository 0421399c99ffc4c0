#include "device/remote/arm_side.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/base/units.h"
#include "core/scene/compile.h"
#include "core/tick/motion.h"

namespace underact::device::remote {
namespace {

constexpr double kLongestTick_s = 0.1;  // as in the servo: after a longer pause everything starts again
constexpr int kNeverForGood = 1'000'000'000;

}  // namespace

Result<ArmSide::Options> optionsOf(const arm::Preset& preset, const servo::DeviceInfo& info, int rate_hz) {
  scene::Description scene;  // the servo's own limits for this arm
  scene.title = "Shared";
  scene.arm = preset.name;
  scene.constraints.push_back({"none", scene::Point{Vec3::Zero()}, target::Side::Both, {}, {}});
  Result<tick::TickProgram> program = scene::compile(scene);
  if (!program) return program.problems();
  ArmSide::Options options;
  options.geometry = preset.geometry;
  options.joint_limits = preset.limits;
  options.limits = program.value().limits;
  options.limits.frozen_s = info.frozen_s;
  options.limits.max_missed = kNeverForGood;  // whether samples and forces come again is for the far servo to judge
  options.period_ns = 1'000'000'000 / std::max(rate_hz, 1);
  return options;
}

ArmSide::ArmSide(servo::DevicePort& port, const Options& options, system::Doorbell& shown)
    : port_(port), options_(options), bell_(shown) {}

void ArmSide::take(const ForceMessage& message) {
  Came& came = came_.back();
  came.arrival = ++arrivals_;
  came.seat = seat_.load(std::memory_order_relaxed);
  came.message = message;
  came_.publish();
}

void ArmSide::seat(bool is_taken) {
  std::uint32_t next = seat_.load(std::memory_order_relaxed) + 1;
  if (((next & 1U) != 0) != is_taken) ++next;
  seat_.store(next, std::memory_order_release);
}

void ArmSide::reset() noexcept {
  energy_ = control::EnergyState{};
  has_last_ = false;
  arm_clock_.reset();
}

/// Whether the newest force may go out. Counts how long none arrived.
bool ArmSide::hears(const Came& came) noexcept {
  const std::uint32_t seat = seat_.load(std::memory_order_acquire);
  if (seat != seated_) {
    seated_ = seat;
    unfresh_ = kQuietPeriods;
    energy_ = control::EnergyState{};
    energy_.energy_J = kLent_J;
    const safety::Heat heat = gate_.heat;
    gate_ = safety::GateState{};
    gate_.heat = heat;
  }
  const bool is_new = came.arrival != arrival_ && came.seat == seat;
  arrival_ = came.arrival;
  const bool heard = unfresh_ < kQuietPeriods;
  unfresh_ = is_new ? 0 : std::min<std::int64_t>(unfresh_ + 1, kQuietPeriods);
  if (heard && unfresh_ == kQuietPeriods && now_.f_T_W != Vec3::Zero()) ++now_.pauses;
  if ((seat & 1U) == 0 || unfresh_ >= kQuietPeriods) return false;
  const std::uint64_t age = now_.sample.sequence - came.message.answered;  // wraps if it answers a future sample
  return age <= static_cast<std::uint64_t>(kOldest_ns / options_.period_ns);
}

Fault ArmSide::judge(bool has, double dt_s) const noexcept {
  if (!has) return {FaultKind::NoSample, 0.0, 0.0};
  for (const double angle_rad : now_.sample.sample.q_rad) {
    if (!std::isfinite(angle_rad)) return {FaultKind::NotFinite, angle_rad, 0.0};
  }
  if (has_last_ && dt_s <= 0.0) return {FaultKind::StaleSample, dt_s, 0.0};
  return {};
}

/// The force with enough damping to take out what the remote spring has generated. Only the forces that arrived are
/// used: the spring itself is not known here.
Vec3 ArmSide::keepPassive(const Vec3& displacement_T_W, double dt_s, const Vec3& f_T_W) noexcept {
  control::PassivityInput passage;
  passage.displacement_T_W = displacement_T_W;
  passage.f_T_W = now_.f_T_W;
  passage.e_W = safety::clampForce(f_T_W, options_.limits.max_force_N);
  passage.level = 1.0;
  passage.dt_s = dt_s;
  passage.pulls = passage.e_W != Vec3::Zero();
  passage.untouched = !passage.pulls;
  control::observe(energy_, passage);
  if (energy_.energy_J < kLent_J) energy_.energy_J = std::min(energy_.energy_J + kLentAgain_W * dt_s, kLent_J);
  energy_.energy_J = std::min(energy_.energy_J, kMaxStored_J);
  energy_.balance_J = energy_.energy_J;
  Vec3 kept_T_W = f_T_W;
  if (options_.is_passive && passage.pulls) {
    const Vec3 damper_T_W = control::damper(energy_, passage);
    if (damper_T_W != Vec3::Zero()) {
      kept_T_W = passage.e_W + damper_T_W;
      if (kept_T_W.dot(passage.e_W) < 0.0) kept_T_W.setZero();  // a wall never pulls
    }
  }
  control::remember(energy_, passage, kept_T_W);
  return kept_T_W;
}

/// The time beyond a period since the tick before began, s.
double ArmSide::beginTick() noexcept {
  const std::int64_t before_ns = at_ns_;
  at_ns_ = options_.counts_time ? before_ns + options_.period_ns : options_.clocks.now_ns();
  if (before_ns == 0) return 0.0;
  return kSecondPerNanosecond * static_cast<double>(std::max<std::int64_t>(at_ns_ - before_ns - options_.period_ns, 0));
}

void ArmSide::noticeSleep() noexcept {
  if (!options_.counts_time) slept_ns_ += sleep_.poll(options_.clocks);
}

/// What other clocks than this computer's report wrong, as in the servo's loop, with the sample at hand and before a
/// force goes out. If nobody pushes there is nothing to stop.
Fault ArmSide::faultOfClocks(bool has) noexcept {
  const arm::Sample& sample = now_.sample.sample;
  const std::int64_t now_ns = options_.counts_time ? at_ns_ : options_.clocks.now_ns();
  Fault odd;
  if (has) odd = arm_clock_.check(sample.time_ns, at_ns_, now_ns, options_.period_ns);
  noticeSleep();
  const std::int64_t slept_ns = std::exchange(slept_ns_, 0);
  if (now_.f_T_W == Vec3::Zero() && gate_.level == 0.0) return {};
  if (slept_ns > 0) return {FaultKind::Asleep, kSecondPerNanosecond * static_cast<double>(slept_ns), 0.0};
  return odd;
}

void ArmSide::tick() noexcept {
  const double waited_s = beginTick();
  SampleMessage& message = now_.sample;
  arm::Sample sample = message.sample;
  const bool has = port_.read(sample);
  if (has && sample.epoch != message.sample.epoch) reset();
  if (has) message.sample = sample;
  ++message.sequence;
  const double since_s =
      has_last_ ? kSecondPerNanosecond * static_cast<double>(message.sample.time_ns - time_ns_) : 0.0;
  const Fault by_clocks = faultOfClocks(has);
  Fault fault = by_clocks.kind != FaultKind::None ? by_clocks : judge(has, since_s);
  message.has_sample = has && fault.kind != FaultKind::NotFinite;
  const double dt_s = fault.kind == FaultKind::None && since_s <= kLongestTick_s ? since_s : 0.0;
  const double period_s = kSecondPerNanosecond * static_cast<double>(options_.period_ns);
  since_s_ += period_s + waited_s;

  safety::GateInput asked;
  safety::Motion& motion = asked.motion;
  Vec3 displacement_T_W = Vec3::Zero();
  if (fault.kind == FaultKind::None) {
    const arm::JointAngles& q_rad = message.sample.q_rad;
    const arm::Kinematics at = arm::kinematics(options_.geometry, q_rad, {false, true});
    const Vec3 p_WT = at.X_WT.translation();
    tick::watchJoints(arm::watchedJoints(options_.geometry), options_.joint_limits, q_rad, at.J, motion);
    if (has_last_) {
      const Vec3 gone_T_W = p_WT - p_WT_;
      if (dt_s > 0.0) displacement_T_W = gone_T_W;
      motion.v_WT = gone_T_W / safety::travelTime_s(since_s, since_s_);
      motion.moved = message.sample.q_rad != q_rad_;
    }
    p_WT_ = p_WT;
    q_rad_ = message.sample.q_rad;
    time_ns_ = message.sample.time_ns;
    has_last_ = true;
    since_s_ = 0.0;
  }

  const Came& came = came_.latest();
  const bool is_heard = hears(came) && options_.allows_force;
  const Vec3 asked_T_W = is_heard && came.message.pushes ? came.message.f_T_W : Vec3(Vec3::Zero());
  // A fault here lasts until the remote servo lets go, too.
  const bool restart = gate_.fault.kind != FaultKind::None && is_heard && asked_T_W == Vec3::Zero();
  const Vec3 kept_T_W = fault.kind == FaultKind::None ? keepPassive(displacement_T_W, dt_s, asked_T_W) : asked_T_W;
  if (fault.kind == FaultKind::None && !is_heard) fault = {FaultKind::StaleSample, 0.0, 0.0};  // zero, at once
  asked.f_T_W = kept_T_W;
  asked.engage = true;
  asked.restart = restart;
  asked.fault = fault;
  asked.waited_s = waited_s;
  const safety::Gated gated = safety::gate(options_.limits, gate_, asked, period_s);
  gate_ = gated.next;
  port_.write(gated.force);
  noticeSleep();  // since it was last checked: this tick's force is withdrawn, and the next one says why
  if (slept_ns_ > 0) port_.write({});
  now_.f_T_W = gated.force.f_T_W();
  if (now_.f_T_W != Vec3::Zero()) now_.max_unfresh = std::max(now_.max_unfresh, unfresh_);
  now_.fault = gate_.fault;
  now_.energy_J = energy_.energy_J;
  shown_.back() = now_;
  shown_.publish();
  beats_->fetch_add(1, std::memory_order_relaxed);
  bell_.ring();
}

}  // namespace underact::device::remote
