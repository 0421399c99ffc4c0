#include <algorithm>
#include <cmath>

#include "core/arm/sample.h"
#include "tests/openhaptics/hd/library.h"

namespace underact::test::hd {
namespace {

// The arm "omni-thesis", by hand: this library is not linked to the program's.
arm::Preset thesisArm() {
  arm::Preset arm;
  arm.geometry = {0.127508, 0.149352, Vec3(0.0, 0.030, -0.176)};
  arm.limits = {{-0.98, 0.0, -0.81, -2.54, 0.62, -2.34}, {0.98, 1.75, 1.37, 2.6, 2.6, 2.34}};
  arm.counts_per_turn = {15280, 15399, 15419, 4915, 4915, 4915};
  arm.continuous_force_N = 0.88;
  return arm;
}

sim::ArmModel weightless() {
  sim::ArmModel model;
  model.mass_kg = 0.0;
  model.friction_N = 0.0;
  return model;
}

constexpr double kTurn_rad = 6.283185307179586;
constexpr int kTremorPeriods = 5;

}  // namespace

Arm::Arm()
    : plant(sim::makePlant(thesisArm(), weightless(), {})), state(sim::restingState(plant, Vec3(0.0, 0.0, 0.06))) {
  setpoint.p_WT = state.p_WT;
}

void Arm::advance(std::int64_t period_ns) {
  ++periods;
  state = sim::advance(plant, state, f_T_W, setpoint, period_ns);
}

std::array<double, 6> Arm::deviceAngles() {
  if (frozen) return shown_;
  const arm::JointAngles device_rad = arm::deviceFromDh(sim::shownAngles(plant, state));
  std::array<double, 6> angles{};
  std::copy_n(device_rad.begin(), angles.size(), angles.begin());
  if (periods / kTremorPeriods % 2 == 1) angles[0] += kTurn_rad / plant.arm.counts_per_turn[0];
  shown_ = angles;
  return angles;
}

std::array<double, 3> Arm::position_mm(const std::array<double, 6>& angles) {
  const double turret = angles[0], thigh = angles[1], shin = angles[2];
  const double reach_mm = 127.508 * std::cos(thigh) + 149.352 * std::sin(shin);
  return {-std::sin(turret) * reach_mm, 127.508 * std::sin(thigh) - 149.352 * std::cos(shin) + 30.0,
          std::cos(turret) * reach_mm - 176.0};
}

}  // namespace underact::test::hd
