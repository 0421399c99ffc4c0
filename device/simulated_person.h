#pragma once
#include <optional>

#include "core/arm/preset.h"
#include "core/identify/measurement.h"
#include "device/simulated_arm.h"

namespace underact::device {

/// Does what a measurement of the arm asks of a person: lets go of the stylus, presses it, turns it. The hand's wishes
/// go the same way as the mouse's.
class SimulatedPerson {
 public:
  /// Both must outlive it; preset: of the arm.
  SimulatedPerson(SimulatedArm& arm, const arm::Preset& preset);
  ~SimulatedPerson();  // takes the stylus again, and wants what it wanted before, unless somebody else's wish came
                       // since
  SimulatedPerson(const SimulatedPerson&) = delete;
  SimulatedPerson& operator=(const SimulatedPerson&) = delete;
  /// To be called often, between two ticks; q_rad: the arm's latest.
  void act(const identify::Measurement& measurement, const arm::JointAngles& q_rad);

 private:
  SimulatedArm& arm_;
  arm::Geometry geometry_;
  sim::HandSetpoint before_;
  std::optional<sim::HandSetpoint> own_;  // the last one
  Mat3 R_WT_ = Mat3::Identity();          // before it is turned
  bool turning_ = false;
};

}  // namespace underact::device
