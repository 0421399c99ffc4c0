#include "device/openhaptics/capabilities.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/arm/forward.h"
#include "core/arm/sample.h"
#include "core/base/units.h"

namespace underact::device::openhaptics {
namespace {

/// Asks the driver for parameters; what it does not know is empty.
class Asker {
 public:
  Asker(const Calls& hd, Drained& worst) : hd_(hd), worst_(worst) { (void)went(); }

  std::optional<double> number(std::uint32_t parameter, double unit) {
    const std::optional<std::array<double, 1>> value = numbers<1>(parameter, unit);
    return value ? std::optional((*value)[0]) : std::nullopt;
  }
  template <std::size_t N>
  std::optional<std::array<double, N>> numbers(std::uint32_t parameter, double unit) {
    std::array<double, kRoom> values{};
    hd_.hdGetDoublev(parameter, values.data());
    return taken<N>(values, unit);
  }
  std::optional<double> singleNumber(std::uint32_t parameter, double unit) {  // for what is known as a float alone
    std::array<float, kRoom> values{};
    hd_.hdGetFloatv(parameter, values.data());
    const std::optional<std::array<double, 1>> value = taken<1>(values, unit);
    return value ? std::optional((*value)[0]) : std::nullopt;
  }
  std::optional<Vec3> vector(std::uint32_t parameter) {
    const std::optional<std::array<double, 3>> values = numbers<3>(parameter, kMetrePerMillimetre);
    return values ? std::optional<Vec3>(Vec3((*values)[0], (*values)[1], (*values)[2])) : std::nullopt;
  }
  std::optional<int> integer(std::uint32_t parameter) {
    std::array<std::int32_t, kRoom> values{};
    hd_.hdGetIntegerv(parameter, values.data());
    return went() ? std::optional<int>(values[0]) : std::nullopt;
  }
  std::optional<bool> flag(std::uint32_t parameter) {
    std::array<std::uint8_t, kRoom> values{};
    hd_.hdGetBooleanv(parameter, values.data());
    return went() ? std::optional(values[0] != 0) : std::nullopt;
  }
  std::optional<std::array<long, 6>> counts(std::uint32_t parameter) {
    std::array<long, kRoom> values{};
    hd_.hdGetLongv(parameter, values.data());
    if (!went()) return {};
    std::array<long, 6> first{};
    std::copy_n(values.begin(), first.size(), first.begin());
    return first;
  }
  /// Printable, and not endless: it goes onto a screen.
  std::optional<std::string> text(std::uint32_t parameter) {
    const char* const given = hd_.hdGetString(parameter);
    if (!went() || given == nullptr) return {};
    constexpr std::size_t kLongest = 200;
    std::string printable;
    for (const char* at = given; *at != '\0' && printable.size() < kLongest; ++at) {
      if (*at >= ' ' && *at <= '~') printable += *at;
    }
    return printable;
  }

 private:
  /// The last question was answered.
  bool went() {
    const Drained drained = drain(hd_);
    if (drained.worst > worst_.worst && drained.worst != Severity::Question) worst_ = drained;
    return drained.worst == Severity::None;
  }
  template <std::size_t N, class Values>
  std::optional<std::array<double, N>> taken(const Values& values, double unit) {
    if (!went()) return {};
    std::array<double, N> first{};
    for (std::size_t i = 0; i < N; ++i) {
      first[i] = unit * static_cast<double>(values[i]);
      if (!std::isfinite(first[i])) return {};
    }
    return first;
  }

  const Calls& hd_;
  Drained& worst_;
};

std::optional<arm::JointAngles> angles(Asker& ask) {
  const std::optional<std::array<double, 3>> joints = ask.numbers<3>(kJointAngles, 1.0);
  const std::optional<std::array<double, 3>> gimbal = ask.numbers<3>(kGimbalAngles, 1.0);
  if (!joints || !gimbal) return {};
  return arm::JointAngles{(*joints)[0], (*joints)[1], (*joints)[2], (*gimbal)[0], (*gimbal)[1], (*gimbal)[2]};
}

std::optional<Mat3> rotation(Asker& ask) {
  const std::optional<std::array<double, 16>> m = ask.numbers<16>(kTransform, 1.0);
  if (!m) return {};
  Mat3 R_WT;  // columns of 4
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) R_WT(row, column) = (*m)[static_cast<std::size_t>(4 * column + row)];
  }
  return R_WT;
}

class Lines {
 public:
  void add(const char* name, const std::optional<std::string>& value) {
    if (value) lines_.push_back(std::string(name) + ": " + *value);
  }
  template <class T>
  void add(const char* name, const std::optional<T>& value, const char* unit, double scale = 1.0) {
    if (!value) return;
    std::ostringstream line;
    line.imbue(std::locale::classic());
    line << name << ": " << scale * static_cast<double>(*value) << unit;
    lines_.push_back(line.str());
  }
  template <class Values>
  void addAll(const char* name, const std::optional<Values>& values, const char* unit, double scale = 1.0) {
    if (!values) return;
    std::ostringstream line;
    line.imbue(std::locale::classic());
    line << name << ":";
    for (const auto& value : *values) line << ' ' << scale * static_cast<double>(value);
    lines_.push_back(line.str() + unit);
  }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

void addDeviation(const Capabilities& is, const arm::Preset& arm, Lines& lines) {
  if (!is.device_angles_rad) return;
  const Pose X_WT = arm::tipPose(arm.geometry, arm::dhFromDevice(*is.device_angles_rad));
  if (is.p_WT) {
    const std::string name = "Tip, by the arm against by the model " + arm.name;
    lines.add(name.c_str(), std::optional((*is.p_WT - X_WT.translation()).norm()), " mm apart", 1e3);
  }
  if (is.R_WT) {
    const double cosine = 0.5 * ((is.R_WT->transpose() * X_WT.linear()).trace() - 1.0);
    lines.add("Stylus, likewise", std::optional(std::acos(std::clamp(cosine, -1.0, 1.0))), " degrees apart",
              180.0 / kPi);
  }
}

}  // namespace

Capabilities readCapabilities(const Calls& hd, Drained& worst) {
  Asker ask(hd, worst);
  Capabilities is;
  is.version = ask.text(kVersion);
  is.model = ask.text(kModel);
  is.driver_version = ask.text(kDriverVersion);
  is.vendor = ask.text(kVendor);
  is.serial = ask.text(kSerial);
  is.firmware = ask.number(kFirmware, 1.0);
  is.max_workspace_m = ask.numbers<6>(kMaxWorkspace, kMetrePerMillimetre);
  is.usable_workspace_m = ask.numbers<6>(kUsableWorkspace, kMetrePerMillimetre);
  is.tabletop_offset_m = ask.singleNumber(kTabletopOffset, kMetrePerMillimetre);
  is.input_dof = ask.integer(kInputDof);
  is.output_dof = ask.integer(kOutputDof);
  is.calibration_styles = ask.integer(kCalibrationStyle);
  is.update_rate_hz = ask.integer(kUpdateRate);
  is.instantaneous_rate_hz = ask.integer(kInstantaneousUpdateRate);
  is.max_stiffness_N_per_m = ask.number(kMaxStiffness, 1e3);
  is.max_damping_N_s_per_m = ask.number(kMaxDamping, 1e3);
  is.max_force_N = ask.number(kMaxForce, 1.0);
  is.max_continuous_force_N = ask.number(kMaxContinuousForce, 1.0);
  is.velocity_limit_m_per_s = ask.number(kVelocityLimit, kMetrePerMillimetre);
  is.impulse_limit_N_per_s = ask.number(kForceImpulseLimit, 1e3);  // N/ms
  is.ramping_rate_N_per_s = ask.number(kForceRampingRate, 1.0);
  is.motor_temperatures = ask.numbers<3>(kMotorTemperature, 1.0);
  is.encoders = ask.counts(kEncoderValues);
  is.safety_switch = ask.flag(kSafetySwitch);
  is.inkwell_switch = ask.flag(kInkwellSwitch);
  is.device_angles_rad = angles(ask);
  is.p_WT = ask.vector(kPosition);
  is.v_WT = ask.vector(kVelocity);
  is.R_WT = rotation(ask);
  return is;
}

std::vector<std::string> listing(const Capabilities& is, const arm::Preset& arm) {
  Lines lines;
  lines.add("Model", is.model);
  lines.add("Maker", is.vendor);
  lines.add("Serial number", is.serial);
  lines.add("Library", is.version);
  lines.add("Driver", is.driver_version);
  lines.add("Firmware", is.firmware, "");
  lines.add("Continuous force", is.max_continuous_force_N, " N");
  lines.add("Largest force", is.max_force_N, " N");
  lines.add("Largest stiffness", is.max_stiffness_N_per_m, " N/mm", 1e-3);
  lines.add("Largest damping", is.max_damping_N_s_per_m, " N s/m");
  lines.add("Speed limit", is.velocity_limit_m_per_s, " m/s");
  lines.add("Limit of the rate of force", is.impulse_limit_N_per_s, " N/s");
  lines.add("Ramping", is.ramping_rate_N_per_s, " N/s");
  lines.addAll("Workspace", is.max_workspace_m, " mm, corner to corner", 1e3);
  lines.addAll("Usable workspace", is.usable_workspace_m, " mm, corner to corner", 1e3);
  lines.add("Table below the origin", is.tabletop_offset_m, " mm", 1e3);
  lines.add("Measured joints", is.input_dof, "");
  lines.add("Driven joints", is.output_dof, "");
  lines.add("Calibration styles (1 reset, 2 automatic, 4 inkwell)", is.calibration_styles, "");
  lines.add("Rate", is.update_rate_hz, " Hz");
  lines.add("Present rate", is.instantaneous_rate_hz, " Hz");
  lines.addAll("Motor temperatures, 0 to 1", is.motor_temperatures, "");
  lines.addAll("Encoders", is.encoders, "");
  lines.add("Inkwell switch", is.inkwell_switch, "");
  lines.add("Safety switch", is.safety_switch, "");
  lines.addAll("Tip", is.p_WT, " mm", 1e3);
  lines.addAll("Velocity", is.v_WT, " mm/s", 1e3);
  lines.addAll("Joint and gimbal angles", is.device_angles_rad, " rad, as reported by the driver");
  addDeviation(is, arm, lines);
  return lines.take();
}

}  // namespace underact::device::openhaptics
