#include "device/simulated_person.h"

#include <cmath>

#include "core/arm/forward.h"
#include "core/base/units.h"

namespace underact::device {
namespace {

using identify::HandTask;
using identify::StageKind;

constexpr double kPress_s = 2.2;
// The hand's own spring and the arm's friction take 1.5 N / 300 N/m of the displacement.
constexpr double kFurther_m = 5e-3;
constexpr double kTurn_rad = 0.25, kTurn_s = 4.0;

/// 0, 1 and 0 again over a press, with a continuous velocity.
double depthAt(double t_s) {
  return 0.5 * (1.0 - std::cos(2.0 * kPi * t_s / kPress_s));
}

bool isSame(const sim::HandSetpoint& a, const sim::HandSetpoint& b) {
  return a.p_WT == b.p_WT && a.v_WT == b.v_WT && a.R_WT == b.R_WT && a.turns == b.turns && a.holds == b.holds;
}

}  // namespace

SimulatedPerson::SimulatedPerson(SimulatedArm& arm, const arm::Preset& preset)
    : arm_(arm), geometry_(preset.geometry), before_(arm.setpoint()) {}

SimulatedPerson::~SimulatedPerson() {
  if (own_ && isSame(arm_.setpoint(), *own_)) arm_.setSetpoint(before_);
  arm_.holdStylus(true);
}

void SimulatedPerson::act(const identify::Measurement& measurement, const arm::JointAngles& q_rad) {
  const identify::Stage& stage = measurement.stage();
  const Pose X_WT = arm::tipPose(geometry_, q_rad);
  if (stage.hand == HandTask::LetsGo || measurement.state() == identify::Measurement::State::Stopped) {
    arm_.holdStylus(false);
    turning_ = false;
    return;
  }
  arm_.holdStylus(true);
  sim::HandSetpoint setpoint;
  setpoint.p_WT = measurement.plan().places_W[stage.place];
  const double t_s = measurement.stageSeconds();
  if (stage.kind == StageKind::Press)
    setpoint.p_WT += depthAt(t_s) * (identify::kPressWay_m + kFurther_m) * identify::kPressAlong_W;
  if (stage.kind == StageKind::Turn) {
    if (!turning_) R_WT_ = X_WT.linear();
    turning_ = true;
    const double turn = 2.0 * kPi * t_s / kTurn_s;
    const Vec3 turn_rad = kTurn_rad * Vec3(std::sin(turn), std::sin(2.0 * turn), std::sin(3.0 * turn));
    setpoint.R_WT = R_WT_;
    if (turn_rad.norm() > 0.0)
      setpoint.R_WT = R_WT_ * Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix();
    setpoint.turns = true;
  }
  arm_.setSetpoint(setpoint);
  own_ = setpoint;
}

}  // namespace underact::device
