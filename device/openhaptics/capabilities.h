#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/arm/preset.h"
#include "device/openhaptics/abi.h"
#include "device/openhaptics/errors.h"

namespace underact::device::openhaptics {

/// What the arm reports about itself, read once, when it is opened; empty where its driver does not know. SI.
struct Capabilities {
  std::optional<std::string> version, model, driver_version, vendor, serial;
  std::optional<double> firmware;
  std::optional<std::array<double, 6>> max_workspace_m, usable_workspace_m;  // corner, corner
  std::optional<double> tabletop_offset_m;
  std::optional<int> input_dof, output_dof, calibration_styles;  // styles: bits of CalibrationStyle
  std::optional<int> update_rate_hz, instantaneous_rate_hz;
  std::optional<double> max_stiffness_N_per_m;  // taken as N/mm, as the vendor's examples do; its manual says "0 to 1"
  std::optional<double> max_damping_N_s_per_m;  // likewise
  std::optional<double> max_force_N, max_continuous_force_N;
  std::optional<double> velocity_limit_m_per_s, impulse_limit_N_per_s, ramping_rate_N_per_s;
  std::optional<std::array<double, 3>> motor_temperatures;  // 0 to 1, motors 1 to 3
  std::optional<std::array<long, 6>> encoders;
  std::optional<bool> safety_switch, inkwell_switch;
  // The tip's position according to the driver: compared with arm::tipPose() of its angles.
  std::optional<arm::JointAngles> device_angles_rad;
  std::optional<Vec3> p_WT, v_WT;
  std::optional<Mat3> R_WT;
};

/// Inside a frame. Errors are drained; worst: the worst of those that mean more than a missing value.
Capabilities readCapabilities(const Calls& hd, Drained& worst);

/// "Model: Touch", one per line, for people and reports: what is known, and the distance between the arm's own tip
/// position and that of the model.
std::vector<std::string> listing(const Capabilities& capabilities, const arm::Preset& arm);

}  // namespace underact::device::openhaptics
