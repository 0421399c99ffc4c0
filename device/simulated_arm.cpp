#include "device/simulated_arm.h"

#include <algorithm>
#include <utility>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/base/excepted.h"
#include "core/base/translate.h"
#include "core/base/units.h"

namespace underact::device {
namespace {

// A mouse reports its position some 60 to 125 times a second: 15 ms bridge the time between two reports.
constexpr double kMouseFilter_s = 0.015;
// A mouse tells several places in one go where the window is slow: they are one.
constexpr std::int64_t kOneGo_ns = 5'000'000;
constexpr double kGlideShare = 1.1;  // of the time between two places

/// One period of the way to a setpoint that jumps: a first-order filter (backward Euler), with the matching velocity.
/// A hand that does not hold is where the tip is, so that it takes hold there without a jerk.
sim::HandSetpoint approach(const sim::HandSetpoint& heeded, const sim::HandSetpoint& goal, const Vec3& p_WT,
                           double dt_s) noexcept UNDERACT_REAL_TIME {
  if (!goal.holds) return {p_WT, Vec3::Zero(), goal.R_WT, goal.turns, false, {}};
  const Vec3 travel_W = (goal.p_WT - heeded.p_WT) * (dt_s / (kMouseFilter_s + dt_s));
  return {heeded.p_WT + travel_W, travel_W / dt_s, goal.R_WT, goal.turns, true, goal.posture};
}

/// In one number, so that two threads always see both parts together.
std::int64_t packed(const Integration& integration) noexcept UNDERACT_REAL_TIME {
  return 4 * integration.substep_ns + static_cast<std::int64_t>(integration.integrator);
}

Integration unpacked(std::int64_t number) noexcept UNDERACT_REAL_TIME {
  return {static_cast<Integrator>(number % 4), number / 4};
}

std::int64_t periodOf(int rate_hz) {
  return 1'000'000'000 / std::max(rate_hz, 1);
}

}  // namespace

SimulatedArm::SimulatedArm(const Options& options)
    : plant_(sim::makePlant(options.arm, options.model, options.hand, options.integration)),
      wanted_arm_(options.arm),
      wanted_model_(options.model),
      start_p_WT_(options.start_p_WT),
      hand_(options.hand),
      integration_(packed(options.integration)),
      state_(options.start_p_WT ? sim::restingState(plant_, *options.start_p_WT) : sim::restingState(plant_)),
      period_ns_(periodOf(options.rate_hz)) {
  heeded_.p_WT = state_.p_WT;
  last_setpoint_.p_WT = state_.p_WT;
  kept_.push_back(options.arm.geometry.mechanism);
}

bool SimulatedArm::read(arm::Sample& sample) noexcept {
  time_ns_ += period_ns_;
  if (has_setpoint_.load(std::memory_order_acquire)) {
    heeded_ = approach(heeded_, glided(wishes_.latest()), state_.p_WT,
                       kSecondPerNanosecond * static_cast<double>(period_ns_));
  } else {
    if (scripted_) heeded_ = sim::setpointAt(script_, time_ns_ - script_start_ns_);
    glide_.p_WT = heeded_.p_WT;  // from here a hand will glide
  }
  Vec3 f_T_W = f_T_W_, m_T_W = m_T_W_;
  if (is_cut_.load(std::memory_order_relaxed)) f_T_W.setZero(), m_T_W.setZero();
  takeUp();
  state_ = sim::advance(plant_, state_, f_T_W, heeded_, period_ns_, m_T_W);
  sample.time_ns = time_ns_;
  sample.epoch = epoch_;
  sample.q_rad = sim::shownAngles(plant_, state_);
  sample.buttons = (button_.load(std::memory_order_relaxed) ? 1U : 0U) | buttons_.load(std::memory_order_relaxed);
  return true;
}

/// The wish, or where the hand is on its way there at the end of this period.
sim::HandSetpoint SimulatedArm::glided(const Wish& wish) noexcept {
  const std::int64_t now_ns = time_ns_ - period_ns_;
  if (wish.number != glide_.number) {
    const bool was_held = heeded_.holds;
    const std::int64_t since_ns = now_ns - glide_.told_ns;
    glide_.number = wish.number;
    if (!wish.glides || !wish.setpoint.holds || !was_held) {
      glide_.p_WT = wish.setpoint.p_WT;
      glide_.told_ns = glide_.arrives_ns = now_ns;
    } else if (since_ns >= kOneGo_ns || glide_.arrives_ns <= now_ns) {
      glide_.told_ns = now_ns;
      glide_.arrives_ns =
          now_ns + std::min(kLongestGlide_ns, static_cast<std::int64_t>(kGlideShare * static_cast<double>(since_ns)));
    }
  }
  const std::int64_t left_ns = std::max(glide_.arrives_ns - now_ns, period_ns_);
  glide_.p_WT += (wish.setpoint.p_WT - glide_.p_WT) * (static_cast<double>(period_ns_) / static_cast<double>(left_ns));
  sim::HandSetpoint there = wish.setpoint;
  there.p_WT = left_ns > period_ns_ ? glide_.p_WT : wish.setpoint.p_WT;
  return there;
}

void SimulatedArm::takeUp() noexcept {
  plant_.integration = unpacked(integration_.load(std::memory_order_relaxed));
  plant_.hand = let_go_.load(std::memory_order_relaxed) ? sim::HandModel{0.0, 0.0, 0.0} : hand_;
  if (!has_figures_.load(std::memory_order_acquire)) return;
  const Figures& figures = figures_.latest();
  plant_.model.mass_kg = figures.mass_kg;
  plant_.model.friction_N = figures.friction_N;
  plant_.model.damping_N_s_per_m = figures.damping_N_s_per_m;
  plant_.model.encoders = figures.encoders;
  plant_.model.of_links = figures.of_links;
  plant_.arm.counts_per_turn = figures.counts_per_turn;
  if (figures.arms == epoch_) return;
  epoch_ = figures.arms;
  UNDERACT_EXCEPTED("counted, and never freed: kept_ has it, too", plant_.arm.geometry = figures.geometry);
  plant_.arm.limits = figures.limits;
  if (!figures.rests) return;
  state_ = figures.rest;
  heeded_ = {};
  heeded_.p_WT = state_.p_WT;
}

void SimulatedArm::write(const safety::GatedForce& force) noexcept {
  f_T_W_ = force.f_T_W();
  m_T_W_ = force.m_T_W();
  is_cut_.store(false, std::memory_order_relaxed);
}

bool SimulatedArm::truth(servo::Truth& truth) const noexcept {
  truth.p_WT = state_.p_WT;
  const double stiffness_N_per_m = heeded_.holds ? plant_.hand.stiffness_N_per_m : 0.0;
  truth.f_hand_T_W =
      stiffness_N_per_m * (heeded_.p_WT - state_.p_WT) + plant_.hand.damping_N_s_per_m * (heeded_.v_WT - state_.v_WT);
  return true;
}

void SimulatedArm::cut() noexcept {
  is_cut_.store(true, std::memory_order_relaxed);
}

servo::DeviceInfo SimulatedArm::info() const {
  return {phrase(TRANSLATE_NOOP("problem", "Simulated arm")), true, false};
}

void SimulatedArm::setRate(int rate_hz) {
  period_ns_ = periodOf(rate_hz);
}

void SimulatedArm::integrate(const Integration& integration) noexcept {
  integration_.store(packed(integration), std::memory_order_relaxed);
}

void SimulatedArm::become(const sim::ArmModel& model) {
  wanted_model_ = model;
  publish();
}

void SimulatedArm::become(const arm::Preset& arm) {
  if (arm.geometry == wanted_arm_.geometry && arm.limits == wanted_arm_.limits &&
      arm.counts_per_turn == wanted_arm_.counts_per_turn && arm.apparent_mass_kg == wanted_arm_.apparent_mass_kg)
    return;
  rests_ = !arm::solvesInTick(arm.geometry) || !arm::solvesInTick(wanted_arm_.geometry);
  wanted_arm_ = arm;
  ++arms_;
  kept_.push_back(arm.geometry.mechanism);
  // A script keeps its own places; a hand that is moved by the mouse goes with the stylus, before the arm does.
  if (rests_) rest_ = sim::restingState(sim::makePlant(arm, wanted_model_, {}));
  if (rests_ && !scripted_) {
    sim::HandSetpoint there;
    there.holds = last_setpoint_.holds;
    there.p_WT = rest_.p_WT;
    setSetpoint(there);
  }
  publish();
}

sim::PlantState SimulatedArm::standing(const std::optional<arm::JointAngles>& q) const {
  const sim::Plant plant = sim::makePlant(wanted_arm_, wanted_model_, {});
  if (!q) {
    const bool began = start_p_WT_ && arm::solvesInTick(wanted_arm_.geometry);
    return began ? sim::restingState(plant, *start_p_WT_) : sim::restingState(plant);
  }
  sim::PlantState state;
  state.q_rad = arm::withinLimits(wanted_arm_.limits, *q);
  state.p_WT = arm::tipPosition(wanted_arm_.geometry, state.q_rad);
  return state;
}

void SimulatedArm::standAt(const std::optional<arm::JointAngles>& q) {
  rest_ = standing(q);
  rests_ = true;
  ++arms_;
  if (!scripted_) {
    sim::HandSetpoint there;
    there.holds = last_setpoint_.holds;
    there.p_WT = rest_.p_WT;
    setSetpoint(there);
  }
  publish();
}

void SimulatedArm::publish() {
  const sim::ArmModel& model = wanted_model_;
  const sim::Plant plant = sim::makePlant(wanted_arm_, model, {});
  figures_.back() = {plant.model.mass_kg,
                     model.friction_N,
                     model.damping_N_s_per_m,
                     model.encoders,
                     plant.model.of_links,
                     plant.arm.counts_per_turn,
                     wanted_arm_.geometry,
                     wanted_arm_.limits,
                     arms_,
                     rests_,
                     rest_};
  figures_.publish();
  has_figures_.store(true, std::memory_order_release);
}

void SimulatedArm::follow(sim::HandScript script) {
  hand_ = script.hand;
  script_ = std::move(script);
  scripted_ = true;
  script_start_ns_ = time_ns_;
  has_setpoint_.store(false, std::memory_order_release);
  if (time_ns_ > 0) return;
  state_ = sim::restingState(plant_, sim::setpointAt(script_, 0).p_WT);
  heeded_.p_WT = state_.p_WT;
  last_setpoint_.p_WT = state_.p_WT;
}

void SimulatedArm::setSetpoint(const sim::HandSetpoint& setpoint) {
  wish(setpoint, false);
}

void SimulatedArm::glideTo(const sim::HandSetpoint& setpoint) {
  wish(setpoint, true);
}

void SimulatedArm::wish(const sim::HandSetpoint& setpoint, bool glides) {
  if (!setpoint.p_WT.allFinite()) return;  // no valid position: the last setpoint stays
  last_setpoint_ = setpoint;
  wishes_.back() = {setpoint, ++wishes_made_, glides};
  wishes_.publish();
  has_setpoint_.store(true, std::memory_order_release);
}

}  // namespace underact::device
