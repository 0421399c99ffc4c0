#include "app/gui/step/step_figures.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/gui/kit/number_table.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/step/step_plot.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

enum FigureOfStep { kFinal, kRise, kSettling, kPeak, kOvershoot, kOmega, kZeta, kError, kLeft, kStepFigures };
enum StepColumn { kModel, kMeasuredStep, kFitted, kStepColumns };

const QString kNone(QChar(0x2013));

QString figureText(double value) {
  if (!std::isfinite(value)) return kNone;
  const int before = value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
  return numberText(value, std::clamp(3 - before, 0, 4));  // four significant digits, at most four decimals
}

QString figureText(const std::optional<double>& value, const QString& none = kNone) {
  return value ? figureText(*value) : none;
}

std::optional<double> inPercent(const std::optional<double>& share) {
  return share ? std::optional(100.0 * *share) : std::nullopt;
}

QString polesText(const lab::TransferFunction& transfer) {
  QStringList words;
  for (const std::complex<double>& pole : lab::poles(transfer)) {
    if (pole.imag() < 0.0) continue;  // listed with its conjugate
    const QString imaginary = pole.imag() > 0.0 ? StepFigures::tr(" ± %1i").arg(figureText(pole.imag())) : QString();
    words << figureText(pole.real()) + imaginary;
  }
  return StepFigures::tr("Poles [rad/s]: %1").arg(words.join(",  "));
}

}  // namespace

StepFigures::StepFigures(QWidget* parent)
    : QWidget(parent),
      table_(new NumberTable("panel.step.table",
                             {{tr("model"), "000.0000"}, {tr("measured"), "000.0000"}, {tr("fit"), "000.0000"}}, this)),
      poles_(quietLabel("panel.step.poles", {}, this)) {
  auto* column = tight<QVBoxLayout>(this, 4);
  table_->addRow(
      tr("Final value"),
      tr("Where the response ends, as a fraction of the step; without damping, the value about which it oscillates."));
  table_->addRow(tr("Rise [s]"), tr("Rise time: from 10 % to 90 % of the final value, each when first reached."));
  table_->addRow(tr("Settling [s]"),
                 tr("Settling time: from then on the response stays within 2 % of the final value."));
  table_->addRow(tr("Peak [s]"), tr("Peak time: when the response is highest, if it exceeds the final value."));
  table_->addRow(tr("Overshoot [%]"),
                 tr("How far the response exceeds the final value; for a second-order system, exp(−π ζ / √(1 − ζ²))."));
  table_->addRow(tr("ωₙ [rad/s]"), tr("Natural frequency: √(kp / m)."));
  table_->addRow(tr("ζ"), tr("Damping ratio: (b + kd) / (2 √(kp m)); 1 is critical."));
  table_->addRow(tr("Error [mm]"), tr("Steady-state error: distance from the tip to the target at the end. Friction "
                                      "can hold the tip up to friction / kp away."));
  table_->addRow(tr("Residual [mm]"), tr("Root mean square difference between the fit and the measured curve."));
  column->addWidget(table_);
  column->addWidget(poles_);
}

void StepFigures::present(const StepPicture& picture, const lab::NaturalMotion& motion) {
  for (int row = 0; row < kStepFigures; ++row) {
    for (int column = 0; column < kStepColumns; ++column) table_->set(row, column, {});
  }
  const auto tell = [this](int column, const lab::StepMetrics& metrics, const QString& never) {
    table_->set(kFinal, column, figureText(metrics.final_value));
    table_->set(kRise, column, figureText(metrics.rise_10_90_s));
    table_->set(kSettling, column, figureText(metrics.settling_2pct_s, never));
    table_->set(kPeak, column, figureText(metrics.peak_time_s));
    table_->set(kOvershoot, column, figureText(inPercent(metrics.overshoot_fraction)));
  };
  poles_->setText(picture.responses.empty() ? QString() : polesText(picture.responses.front().transfer));
  if (picture.responses.empty()) return;
  tell(kModel, picture.metrics, tr("never"));
  table_->set(kOmega, kModel, figureText(motion.omega_n_rad_per_s));
  table_->set(kZeta, kModel, figureText(motion.zeta));
  if (!picture.measured) return;
  tell(kMeasuredStep, lab::metricsOf(*picture.measured), tr("never"));
  table_->set(kError, kMeasuredStep, figureText(kMillimetrePerMetre * picture.steady_error_m));
  if (!picture.fit) return;
  lab::StepMetrics fit = lab::metricsOf(lab::secondOrder(picture.fit->omega_n_rad_per_s, picture.fit->zeta));
  fit.final_value = picture.fit->gain;
  tell(kFitted, fit, tr("never"));
  table_->set(kOmega, kFitted, figureText(picture.fit->omega_n_rad_per_s));
  table_->set(kZeta, kFitted, figureText(picture.fit->zeta));
  table_->set(kLeft, kFitted, figureText(kMillimetrePerMetre * picture.fit->residual));
}

}  // namespace underact::gui
