#include "core/identify/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/translate.h"
#include "core/base/units.h"

namespace underact::identify {
namespace {

constexpr double kGrammePerKilogramme = 1e3, kMicrometrePerMetre = 1e6;
const char* const kJoints[] = {TRANSLATE_NOOP("problem", "turret"),   TRANSLATE_NOOP("problem", "thigh"),
                               TRANSLATE_NOOP("problem", "shin"),     TRANSLATE_NOOP("problem", "gimbal 1"),
                               TRANSLATE_NOOP("problem", "gimbal 2"), TRANSLATE_NOOP("problem", "gimbal 3")};

Estimate times(const Estimate& estimate, double factor) {
  return {factor * estimate.value, factor * estimate.uncertainty};
}

/// Fixed notation with so many digits behind the point.
std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(digits, 0, 9), value);
  return text;
}

/// Digits behind the point for two digits of the uncertainty.
int digitsOf(double uncertainty) {
  if (!(uncertainty > 0.0)) return 4;
  return static_cast<int>(1.0 - std::floor(std::log10(uncertainty)));
}

/// The mean first, then axis by axis.
void addAxes(std::vector<ReportRow>& rows, const char* name, const char* unit, double factor, const Estimate& mean,
             const std::array<Estimate, 3>& axes, std::optional<double> given) {
  if (given) *given *= factor;
  rows.push_back({phrase(name), unit, times(mean, factor), given});
  for (std::size_t axis = 0; axis < 3; ++axis)
    rows.push_back({phrase(TRANSLATE_NOOP("problem", "%1 along %2"), {phrase(name), std::string(1, "xyz"[axis])}), unit,
                    times(axes[axis], factor), given});
}

void addStiffness(std::vector<ReportRow>& rows, const Identified& found) {
  if (found.press) {
    const Press& press = *found.press;
    const double spread = press.stiffness_N_per_m.uncertainty / kNewtonPerMetre;
    rows.push_back({phrase(TRANSLATE_NOOP("problem", "Stiffness in a slow press")), "N/mm",
                    times(press.stiffness_N_per_m, 1.0 / kNewtonPerMetre), kPress_N_per_mm});
    rows.push_back({phrase(TRANSLATE_NOOP("problem", "Hysteresis of the press")),
                    "N",
                    {std::abs(press.hysteresis_N), std::max(press.residual_N, spread)}});
    rows.push_back({phrase(press.clamped_at_m ? TRANSLATE_NOOP("problem", "Linear up to the clamp, at")
                                              : TRANSLATE_NOOP("problem", "Linear at least up to")),
                    "mm",
                    {kMillimetrePerMetre * press.clamped_at_m.value_or(press.linear_m), 0.0}});
  }
  for (const AxisSwings& one : found.swings) {
    if (!one.stiffness || one.place > 0) continue;
    rows.push_back(
        {phrase(TRANSLATE_NOOP("problem", "Stiffness of a free swing along %1"), {std::string(1, "xyz"[one.axis])}),
         "N/mm", times({one.stiffness->value_N_per_m, one.stiffness->uncertainty_N_per_m}, 1.0 / kNewtonPerMetre),
         kSwing_N_per_mm});
  }
}

std::string line(const ReportRow& row, bool compares) {
  std::string text =
      "| " + row.quantity + " | " + valueText(row) + " | " + uncertaintyText(row) + " | " + row.unit + " |";
  if (compares) text += " " + (row.given ? fixed(*row.given, 4) : std::string()) + " | " + differenceText(row) + " |";
  return text + "\n";
}

}  // namespace

std::vector<ReportRow> rowsOf(const Identified& found, const Given* given) {
  std::vector<ReportRow> rows;
  const auto of = [&](double sim::ArmModel::*what) { return given ? std::optional(given->model.*what) : std::nullopt; };
  addAxes(rows, TRANSLATE_NOOP("problem", "Mass"), "g", kGrammePerKilogramme, found.mean_mass_kg, found.mass_kg,
          of(&sim::ArmModel::mass_kg));
  addAxes(rows, TRANSLATE_NOOP("problem", "Friction"), "N", 1.0, found.mean_friction_N, found.friction_N,
          of(&sim::ArmModel::friction_N));
  addAxes(rows, TRANSLATE_NOOP("problem", "Damping"), "N s/m", 1.0, found.mean_damping_N_s_per_m,
          found.damping_N_s_per_m, of(&sim::ArmModel::damping_N_s_per_m));
  for (std::size_t joint = 0; joint < 6; ++joint) {
    if (!found.counts_per_turn[joint]) continue;
    rows.push_back({phrase(TRANSLATE_NOOP("problem", "Counts per turn, %1"), {phrase(kJoints[joint])}), "",
                    *found.counts_per_turn[joint], given ? std::optional(given->counts_per_turn[joint]) : std::nullopt,
                    1});
  }
  rows.push_back({phrase(TRANSLATE_NOOP("problem", "Noise of the tip at rest")),
                  "µm",
                  {kMicrometrePerMetre * found.rest_noise_m.norm(), 0.0}});
  rows.push_back({phrase(TRANSLATE_NOOP("problem", "Noise of the tip in slow motion")),
                  "µm",
                  {kMicrometrePerMetre * found.slow_noise_m.norm(), 0.0}});
  addStiffness(rows, found);
  return rows;
}

Sentence valueText(const ReportRow& row) {
  const Estimate& estimate = row.estimate;
  if (!std::isfinite(estimate.value)) return phrase(TRANSLATE_NOOP("problem", "none"));
  if (estimate.uncertainty == 0.0) return shownNumber(fixed(estimate.value, std::min(row.max_digits, 2)));
  const int digits = std::min(digitsOf(estimate.uncertainty), row.max_digits);
  if (estimate.isSignificant()) return shownNumber(fixed(estimate.value, digits));
  const double unit = std::pow(10.0, -digits);
  return phrase(TRANSLATE_NOOP("problem", "below %1"),
                {shownNumber(fixed(std::ceil(estimate.limit() / unit) * unit, digits))});
}

Sentence uncertaintyText(const ReportRow& row) {
  const double uncertainty = row.estimate.uncertainty;
  if (!(uncertainty > 0.0) || !std::isfinite(uncertainty)) return "";
  const double min = std::pow(10.0, -row.max_digits);
  if (uncertainty < min) return shownNumber("< " + fixed(min, row.max_digits));
  return shownNumber(fixed(uncertainty, std::min(digitsOf(uncertainty), row.max_digits)));
}

Sentence differenceText(const ReportRow& row) {
  if (!row.given || *row.given == 0.0 || !row.estimate.isSignificant()) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%+.2f %%", 100.0 * (row.estimate.value / *row.given - 1.0));
  return shownNumber(text);
}

std::string methodSentence() {
  return "Swings to targets 10 mm to each side along x, y and z under 0.1 N/mm, a rest, a slow press under 0.5 N/mm; "
         "least squares of a mass with Coulomb friction and damping under the force that was sent.";
}

sim::ArmModelFile modelFileOf(const Identified& found, const std::string& name, const std::string& title,
                              sim::Provenance provenance) {
  const auto told = [](const Estimate& estimate) { return estimate.isSignificant() ? estimate.value : 0.0; };
  sim::ArmModelFile file;
  file.arm.name = name;
  file.arm.title = title;
  file.arm.mass_kg = told(found.mean_mass_kg);
  file.arm.friction_N = told(found.mean_friction_N);
  file.arm.damping_N_s_per_m = told(found.mean_damping_N_s_per_m);
  arm::EncoderCounts counts{};
  for (std::size_t joint = 0; joint < 6; ++joint) {
    if (found.counts_per_turn[joint]) counts[joint] = found.counts_per_turn[joint]->value;
  }
  file.arm.encoders = std::any_of(counts.begin(), counts.end(), [](double count) { return count > 0.0; });
  if (file.arm.encoders) file.arm.counts_per_turn = counts;
  provenance.rate_hz = found.rate_hz;
  for (const Vec3& p_W : found.places_W) provenance.places_mm.push_back(kMillimetrePerMetre * p_W);
  if (provenance.method.empty()) provenance.method = methodSentence();
  file.provenance = std::move(provenance);
  file.arm.provenance = sim::sentenceOf(file.provenance);
  file.uncertainty = sim::ModelUncertainty{found.mean_mass_kg.uncertainty, found.mean_friction_N.uncertainty,
                                           found.mean_damping_N_s_per_m.uncertainty};
  return file;
}

std::string reportText(const Identified& found, const sim::ArmModelFile& file, const Given* given) {
  std::string text = "# " + file.arm.title + "\n\n" + file.arm.provenance + "\n\n";
  text += "Arm: " + found.arm + ". Positions (mm):";
  for (const Vec3& p_W : found.places_W) {
    const Vec3 p_mm = kMillimetrePerMetre * p_W;
    text += " (" + fixed(p_mm.x(), 1) + ", " + fixed(p_mm.y(), 1) + ", " + fixed(p_mm.z(), 1) + ")";
  }
  text += given ? ".\n\n| quantity | value | uncertainty | unit | given | difference |\n|---|---|---|---|---|---|\n"
                : ".\n\n| quantity | value | uncertainty | unit |\n|---|---|---|---|\n";
  for (const ReportRow& row : rowsOf(found, given)) text += line(row, given != nullptr);
  text +=
      "\nUncertainty: one standard deviation, by the fit and the differences between its swings; for a mean over "
      "directions that differ by more than chance explains, by their scatter. "
      "\"Below\": not distinguishable from zero; the true value lies below that with 97 % probability.\n";
  for (const AxisSwings& one : found.swings)
    text += std::string("\nSwings along ") + "xyz"[one.axis] + " at position " + std::to_string(one.place + 1) + ": " +
            std::to_string(one.windows.size()) + " windows, residual of the fit " +
            fixed(kMicrometrePerMetre * one.fit.residual_m, 1) + " µm (root mean square), pull " +
            fixed(one.fit.body.bias_N, 4) + " N.\n";
  for (const Problem& note : found.notes) text += "\nNot measured: " + note.sentence + "\n";
  return text;
}

}  // namespace underact::identify
