#include "app/cli/step_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <ostream>

#include "core/base/printed.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/lab/unit_step.h"

namespace underact::cli {
namespace {

using json::numberText;

constexpr int kCurveSteps = 1000;

const char* wordOf(scene::LawType law) {
  return law == scene::LawType::P ? "P" : law == scene::LawType::PD ? "PD" : "PID";
}

void addNumber(JsonObject& object, const char* key, const std::optional<double>& value) {
  value ? object.addNumber(key, *value) : object.addNull(key);
}

/// A number as people read it, or the meaning of its absence.
std::string shown(const std::optional<double>& value, const std::string& unit, const char* none) {
  if (!value) return none;
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", *value);
  return text + (unit.empty() ? unit : " " + unit);
}

std::ostream& row(std::ostream& out, const std::string& what) {
  return out << std::left << std::setw(18) << what;
}

void printTimes(const lab::StepMetrics& metrics, const std::string& overshoot, std::ostream& out) {
  row(out, "rise 10-90 %") << shown(metrics.rise_10_90_s, "s", "none") << '\n';
  row(out, "settling 2 %") << shown(metrics.settling_2pct_s, "s", "never") << '\n';
  row(out, "peak") << shown(metrics.peak_time_s, "s", "none") << '\n';
  row(out, "overshoot") << overshoot << '\n';
}

std::string percent(const std::optional<double>& share) {
  return share ? shown(100.0 * *share, "%", "") : "none";
}

void printPoles(const lab::TransferFunction& transfer, std::ostream& out) {
  for (const std::complex<double>& pole : lab::poles(transfer)) {
    if (pole.imag() < 0.0) continue;  // printed with its partner
    row(out, "pole") << shown(pole.real(), "", "");
    if (pole.imag() > 0.0) out << " +- " << shown(pole.imag(), "", "") << "i";
    out << " rad/s\n";
  }
}

JsonObject fitObject(const lab::SecondOrderFit& fit, double step_m) {
  JsonObject object;
  object.addNumber("omega_n_rad_per_s", fit.omega_n_rad_per_s);
  object.addNumber("zeta", fit.zeta);
  object.addNumber("gain", fit.gain / step_m);
  object.addNumber("residual_mm", kMillimetrePerMetre * fit.residual);
  return object;
}

JsonObject modelObject(const lab::ArmStep& step) {
  JsonObject object;
  object.addNumber("mass_kg", step.model.mass_kg);
  object.addNumber("damping_N_s_per_m", step.model.damping_N_s_per_m);
  object.addNumber("kp_N_per_mm", step.model.kp_N_per_m / kNewtonPerMetre);
  object.addNumber("kd_N_s_per_mm", step.model.kd_N_s_per_m / kNewtonPerMetre);
  object.addNumber("ki_N_per_mm_s", step.model.ki_N_per_m_s / kNewtonPerMetre);
  object.addNumber("friction_N", step.friction_N);  // of the simulated arm; the model has none
  const lab::NaturalMotion motion = lab::naturalMotion(step.model, step.law);
  object.addNumber("omega_n_rad_per_s", motion.omega_n_rad_per_s);
  object.addNumber("zeta", motion.zeta);
  Eigen::MatrixXd roots(0, 2);
  for (const std::complex<double>& pole : lab::poles(step.analytic)) {
    roots.conservativeResize(roots.rows() + 1, 2);
    roots.bottomRows<1>() << pole.real(), pole.imag();
  }
  object.addMatrix("poles_rad_per_s", roots);
  object.addObject("step", metricsObject(lab::metricsOf(step.analytic)));
  return object;
}

}  // namespace

JsonObject metricsObject(const lab::StepMetrics& metrics) {
  JsonObject object;
  addNumber(object, "final_value", metrics.final_value);
  addNumber(object, "rise_10_90_s", metrics.rise_10_90_s);
  addNumber(object, "settling_2pct_s", metrics.settling_2pct_s);
  addNumber(object, "peak_time_s", metrics.peak_time_s);
  addNumber(object, "overshoot_fraction", metrics.overshoot_fraction);
  return object;
}

JsonObject stepObject(const lab::ArmStep& step) {
  JsonObject object;
  object.addText("constraint", step.constraint);
  object.addText("law", wordOf(step.law));
  object.addText("axis", name(step.axis));
  object.addVector("direction", step.along_W);
  object.addNumber("step_mm", kMillimetrePerMetre * step.step_m);
  object.addVector("from_mm", kMillimetrePerMetre * step.p_WBefore);
  object.addInteger("rate_hz", step.rate_hz);
  object.addNumber("seconds", step.travel_m.period_s * static_cast<double>(step.travel_m.value.size() - 1));
  const std::optional<double>& end_m = step.measured.final_value;
  object.addNumber("final_mm", end_m ? kMillimetrePerMetre * *end_m : kNotANumber);
  addNumber(object, "rise_10_90_s", step.measured.rise_10_90_s);
  addNumber(object, "settling_2pct_s", step.measured.settling_2pct_s);
  addNumber(object, "peak_time_s", step.measured.peak_time_s);
  addNumber(object, "overshoot_fraction", step.measured.overshoot_fraction);
  object.addNumber("steady_error_mm", kMillimetrePerMetre * step.steady_error_m);
  object.addNumber("peak_force_N", step.peak_force_N);
  object.addInteger("limited_ticks", step.limited_ticks);
  step.fit ? object.addObject("fit", fitObject(*step.fit, step.step_m)) : object.addNull("fit");
  object.addObject("model", modelObject(step));
  object.addText("fault", step.fault);
  return object;
}

void printStep(const lab::TransferFunction& transfer, const lab::StepMetrics& metrics, std::ostream& out) {
  row(out, "final value") << shown(metrics.final_value, "", "none") << '\n';
  printTimes(metrics, percent(metrics.overshoot_fraction), out);
  printPoles(transfer, out);
}

void printStep(const lab::ArmStep& step, std::ostream& out) {
  const lab::StepMetrics model = lab::metricsOf(step.analytic);
  const lab::NaturalMotion motion = lab::naturalMotion(step.model, step.law);
  const auto line = [&out](const char* what, const std::string& measured, const std::string& fit,
                           const std::string& analytic) {
    row(out, what) << std::setw(16) << measured << std::setw(16) << fit << analytic << '\n';
  };
  const auto mm = [](const std::optional<double>& length_m) {
    return length_m ? shown(kMillimetrePerMetre * *length_m, "mm", "") : std::string("none");
  };
  std::optional<double> fit_final, fit_omega, fit_zeta;
  lab::StepMetrics fit;
  if (step.fit) {
    fit_final = step.fit->gain;
    fit_omega = step.fit->omega_n_rad_per_s;
    fit_zeta = step.fit->zeta;
    fit = lab::metricsOf(lab::secondOrder(*fit_omega, *fit_zeta));
  }
  row(out, "constraint") << printed(step.constraint) << ", " << wordOf(step.law) << ", " << mm(step.step_m) << " along "
                         << (step.axis == lab::Axis::Held ? "the held direction" : name(step.axis)) << '\n';
  line("", "measured", "fit", "model");
  const std::optional<double> model_final =
      model.final_value ? std::optional(step.step_m * *model.final_value) : std::nullopt;
  line("final", mm(step.measured.final_value), mm(fit_final), mm(model_final));
  line("rise 10-90 %", shown(step.measured.rise_10_90_s, "s", "none"), shown(fit.rise_10_90_s, "s", "none"),
       shown(model.rise_10_90_s, "s", "none"));
  line("settling 2 %", shown(step.measured.settling_2pct_s, "s", "never"), shown(fit.settling_2pct_s, "s", "never"),
       shown(model.settling_2pct_s, "s", "never"));
  line("peak", shown(step.measured.peak_time_s, "s", "none"), shown(fit.peak_time_s, "s", "none"),
       shown(model.peak_time_s, "s", "none"));
  line("overshoot", percent(step.measured.overshoot_fraction), percent(fit.overshoot_fraction),
       percent(model.overshoot_fraction));
  line("omega_n", "", shown(fit_omega, "rad/s", "none"), shown(motion.omega_n_rad_per_s, "rad/s", "none"));
  line("zeta", "", shown(fit_zeta, "", "none"), shown(motion.zeta, "", "none"));
  row(out, "steady error") << mm(step.steady_error_m) << '\n';
  if (step.fit) row(out, "residual of the fit") << mm(step.fit->residual) << " (root mean square)\n";
  row(out, "model") << shown(step.model.mass_kg, "kg", "") << ", " << shown(step.model.damping_N_s_per_m, "N s/m", "")
                    << ", no friction (the arm: " << shown(step.friction_N, "N", "") << ")\n";
  printPoles(step.analytic, out);
}

std::string noteOn(const lab::TransferFunction& transfer) {
  switch (lab::behaviourOf(transfer)) {
    case lab::Behaviour::Grows:
      return "The response grows without bound: a pole lies to the right of the imaginary axis, or a double pole on "
             "it. Nothing can be measured.";
    case lab::Behaviour::Drifts:
      return "The response drifts for ever: a pole lies at 0 (an integrator). It has no final value.";
    case lab::Behaviour::Swings:
      return "The response oscillates for ever: there is no damping. The final value is the one about which it "
             "oscillates.";
    case lab::Behaviour::Settles:
      break;
  }
  return lab::gainAtRest(transfer) == 0.0 ? "The response ends at 0, so rise time and overshoot are not defined." : "";
}

std::vector<std::string> notesOn(const lab::ArmStep& step) {
  std::vector<std::string> notes;
  if (!step.fault.empty()) notes.push_back(step.fault);
  if (step.limited_ticks > 0)
    notes.push_back("The safety gate reduced the force in " + std::to_string(step.limited_ticks) +
                    " ticks, so the response is not linear. Make the step smaller, or measure with --no-limits.");
  const double pull_N = step.model.kp_N_per_m * std::abs(step.step_m);
  if (!step.fit && pull_N <= step.friction_N)
    notes.push_back("The tip did not move: " + shown(pull_N, "N", "") + " does not overcome the arm's friction of " +
                    shown(step.friction_N, "N", "") + ". Make the step larger.");
  return notes;
}

std::string csvOf(const lab::TransferFunction& transfer, double seconds) {
  if (!(seconds > 0.0)) seconds = lab::plotDuration_s(transfer);
  const lab::UnitStep step(transfer);
  std::string text = "t_s,y\n";
  for (int index = 0; index <= kCurveSteps; ++index) {
    const double t_s = seconds * index / kCurveSteps, y = step.at(t_s);
    text += numberText(t_s) + ',' + (std::isfinite(y) ? numberText(y) : "") + '\n';
  }
  return text;
}

std::string csvOf(const lab::ArmStep& step) {
  const lab::UnitStep analytic(step.analytic);
  std::string text = "t_s,measured_mm,fit_mm,analytic_mm\n";
  for (std::size_t index = 0; index < step.travel_m.value.size(); ++index) {
    const double t_s = step.travel_m.period_s * static_cast<double>(index);
    text += numberText(t_s) + ',' + numberText(kMillimetrePerMetre * step.travel_m.value[index]) + ',';
    if (step.fit) {
      const double y = lab::secondOrderAt(step.fit->omega_n_rad_per_s, step.fit->zeta, t_s);
      text += numberText(kMillimetrePerMetre * step.fit->gain * y);
    }
    text += ',' + numberText(kMillimetrePerMetre * step.step_m * analytic.at(t_s)) + '\n';
  }
  return text;
}

Problems writeText(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (file) return {};
  return {{"The file could not be written. Check that the folder exists and that the disk has room.", {path}}};
}

}  // namespace underact::cli
