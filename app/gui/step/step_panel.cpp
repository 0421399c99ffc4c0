#include "app/gui/step/step_panel.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/kit/number_table.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/arm_in_use.h"
#include "app/gui/model/document.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/step/step_plot.h"
#include "core/base/units.h"
#include "core/lab/thesis_steps.h"
#include "core/scene/edit.h"

namespace underact::gui {
namespace {

using lab::Behaviour;

enum Row { kFinal, kRise, kSettling, kPeak, kOvershoot, kOmega, kZeta, kError, kLeft, kRows };
enum Column { kModel, kMeasured, kFitted, kColumns };

const QString kNone(QChar(0x2013));

QString figureText(double value) {
  if (!std::isfinite(value)) return kNone;
  const int before = value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
  return numberText(value, std::clamp(3 - before, 0, 4));  // four digits that count, at most four behind the point
}

QString figureText(const std::optional<double>& value, const QString& none = kNone) {
  return value ? figureText(*value) : none;
}

std::optional<double> percent(const std::optional<double>& share) {
  return share ? std::optional(100.0 * *share) : std::nullopt;
}

QString sentenceOn(const lab::TransferFunction& transfer) {
  switch (lab::behaviourOf(transfer)) {
    case Behaviour::Grows:
      return StepPanel::tr("It grows without end: a pole lies right of the imaginary axis, or twice on it.");
    case Behaviour::Drifts:
      return StepPanel::tr("It goes on for ever: a pole lies at 0.");
    case Behaviour::Swings:
      return StepPanel::tr("It swings for ever: nothing damps it.");
    case Behaviour::Settles:
      break;
  }
  return {};
}

QString polesText(const lab::TransferFunction& transfer) {
  QStringList words;
  for (const std::complex<double>& pole : lab::poles(transfer)) {
    if (pole.imag() < 0.0) continue;  // told with its partner
    const QString imaginary = pole.imag() > 0.0 ? StepPanel::tr(" ± %1i").arg(figureText(pole.imag())) : QString();
    words << figureText(pole.real()) + imaginary;
  }
  return StepPanel::tr("Poles [rad/s]: %1").arg(words.join(",  "));
}

/// Of den = a s^2 + b s + c; none of another degree.
lab::NaturalMotion naturalMotionOf(const lab::TransferFunction& transfer) {
  if (transfer.den.size() != 3) return {kNotANumber, kNotANumber};
  const lab::HeldMass held{transfer.den[0], transfer.den[1], transfer.den[2]};
  return naturalMotion(held, scene::LawType::P);
}

}  // namespace

StepPanel::StepPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  held_.kp_N_per_m = 500.0;
  build();
  takeArm();
  addCommands();
  connect(&parts_.document, &Document::opened, this, &StepPanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &StepPanel::sceneEdited);
  connect(&parts_.arm_in_use, &ArmInUse::changed, this, &StepPanel::takeArm);
  connect(&parts_.rate, &ServoRate::changed, this, [this] {  // it was measured at another one
    measured_.reset();
    refresh();
  });
  sceneOpened();
}

double& StepPanel::valueOf(int quantity) {
  double* const values[] = {&held_.kp_N_per_m, &held_.kd_N_s_per_m, &held_.ki_N_per_m_s, &held_.mass_kg,
                            &held_.damping_N_s_per_m};
  return *values[quantity];
}

const scene::Control& StepPanel::control() const {
  return scene::controlOf(parts_.document.scene(), index_);
}

/// The mass that moves and what slows it are the arm's, until a slider says otherwise.
void StepPanel::takeArm() {
  held_.mass_kg = parts_.arm_in_use.model().mass_kg;
  held_.damping_N_s_per_m = parts_.arm_in_use.model().damping_N_s_per_m;
  measured_.reset();
  refresh();
}

void StepPanel::listConstraints() {
  const std::vector<scene::Constraint>& constraints = parts_.document.scene().constraints;
  const QSignalBlocker silent(constraint_);
  constraint_->clear();
  for (const scene::Constraint& one : constraints) constraint_->addItem(QString::fromStdString(one.name));
  if (index_ >= constraints.size()) index_ = 0;
  constraint_->setCurrentIndex(static_cast<int>(index_));
  choices_->setRowVisible(constraint_, constraints.size() > 1);
}

void StepPanel::sceneOpened() {
  index_ = 0;
  listConstraints();
  measured_.reset();
  if (!takeFromScene()) refresh();
}

void StepPanel::sceneEdited() {
  listConstraints();
  refresh();  // the marks of the scene's own gains
}

bool StepPanel::showFigure(int figure) {
  figure_ = figure;
  refresh();
  return true;
}

bool StepPanel::setLaw(scene::LawType law) {
  law_ = law;
  measured_.reset();
  refresh();
  return true;
}

bool StepPanel::setQuantity(int quantity, double value) {
  if (!(value >= 0.0 && std::isfinite(value))) return false;
  valueOf(quantity) = quantity <= kKi ? kNewtonPerMetre * value : value;
  measured_.reset();
  refresh();
  return true;
}

bool StepPanel::takeFromScene() {
  if (parts_.document.scene().constraints.empty()) return false;
  const scene::Gains& gains = control().gains;
  law_ = control().law;
  held_.kp_N_per_m = kNewtonPerMetre * gains.kp_N_per_mm.x();
  held_.kd_N_s_per_m = kNewtonPerMetre * gains.kd_N_s_per_mm.x();
  held_.ki_N_per_m_s = kNewtonPerMetre * gains.ki_N_per_mm_s.x();
  measured_.reset();
  refresh();
  return true;
}

namespace {

scene::Control withGains(scene::Control control, scene::LawType law, const lab::HeldMass& held) {
  control.law = law;
  control.gains.kp_N_per_mm.setConstant(held.kp_N_per_m / kNewtonPerMetre);
  control.gains.kd_N_s_per_mm.setConstant(held.kd_N_s_per_m / kNewtonPerMetre);
  control.gains.ki_N_per_mm_s.setConstant(held.ki_N_per_m_s / kNewtonPerMetre);
  return control;
}

}  // namespace

bool StepPanel::giveToScene() {
  if (parts_.document.scene().constraints.empty()) return false;
  const scene::Description edited = withControl(parts_.document.scene(), index_, withGains(control(), law_, held_));
  const Problems problems =
      parts_.document.edit(edited, tr("gains of the step response"), parts_.document.newGesture());
  if (!problems.empty()) note_->setText(sentencesOf(problems));
  return problems.empty();
}

// In the window's thread: 20,000 ticks, the most it asks for, take half a second, so there is nothing to cancel.
bool StepPanel::measure() {
  const scene::Description& scene = parts_.document.scene();
  if (scene.constraints.empty()) return false;
  lab::StepSetup setup;
  setup.step_m = kMetrePerMillimetre * step_mm_->value();
  setup.constraint = scene.constraints[index_].name;
  setup.arm = parts_.arm_in_use.model();
  setup.arm.mass_kg = held_.mass_kg;
  setup.arm.damping_N_s_per_m = held_.damping_N_s_per_m;  // a hand's, too: at rest it slows as the arm's own does
  setup.rate_hz = parts_.servo.rateHz();
  setup.limits = limits_->isChecked();
  Result<lab::ArmStep> step = lab::measureStep(withControl(scene, index_, withGains(control(), law_, held_)), setup);
  if (step) measured_ = std::move(step).value();
  figure_choice_->setCurrentIndex(0);
  refresh();
  if (!step) note_->setText(sentencesOf(step.problems()));
  return static_cast<bool>(step);
}

StepPicture StepPanel::pictureOfArm(QString& note) const {
  StepPicture picture;
  const Result<lab::TransferFunction> transfer = lab::transferOf(held_, law_);
  if (!transfer) {
    note = sentencesOf(transfer.problems());
    return picture;
  }
  picture.responses = {{tr("model"), transfer.value()}};
  picture.metrics = lab::metricsOf(transfer.value());
  picture.seconds = lab::secondsToSee(transfer.value());
  note = sentenceOn(transfer.value());
  if (!measured_) return picture;
  lab::Curve share = measured_->way_m;
  for (double& value : share.value) value /= measured_->step_m;
  const double length_s = share.period_s * static_cast<double>(share.value.size() - 1);
  const double rest_s = measured_->measured.settling_2pct_s.value_or(0.0);
  if (picture.metrics.settling_2pct_s)
    picture.seconds = std::max(picture.seconds, 1.5 * rest_s);
  else
    picture.seconds = rest_s > 0.0 ? 1.5 * rest_s : length_s;
  picture.measured = std::move(share);
  picture.fit = measured_->fit;
  if (picture.fit) picture.fit->gain /= measured_->step_m;
  note = noteOnMeasured();
  return picture;
}

QString StepPanel::noteOnMeasured() const {
  const lab::ArmStep& step = *measured_;
  if (!step.fault.empty()) return QString::fromStdString(step.fault);
  const double pull_N = step.model.kp_N_per_m * step.step_m;
  if (!step.fit && pull_N <= step.friction_N)
    return tr("The tip did not move: %1 N do not overcome the arm's friction of %2 N. Make the step larger.")
        .arg(numberText(pull_N, 2))
        .arg(numberText(step.friction_N, 2));
  if (step.limited_ticks > 0)
    return tr("The gate cut the force in %1 ticks, so this is no linear response. Make the step smaller, or measure "
              "without the limits.")
        .arg(step.limited_ticks);
  const QString arm = QString::fromStdString(parts_.arm_in_use.model().name);
  return tr("Measured along %1%3. The model has no friction; the arm has %2 N.")
      .arg(step.axis == lab::Axis::Held ? tr("the direction in which it holds") : QString(name(step.axis)))
      .arg(numberText(step.friction_N, 2))
      .arg(parts_.arm_in_use.isMeasured() ? tr(" on “%1”").arg(arm) : QString());
}

void StepPanel::refresh() {
  QString note;
  StepPicture picture;
  if (figure_ == 0) {
    picture = pictureOfArm(note);
  } else {
    const lab::ThesisStep& step = lab::thesisSteps()[static_cast<std::size_t>(figure_) - 1];
    for (const lab::ThesisStep::Response& one : step.responses)
      picture.responses.push_back({QCoreApplication::translate("step", one.name), one.transfer});
    picture.metrics = lab::metricsOf(step.responses.front().transfer);
    picture.seconds = step.seconds;
    note = sentenceOn(step.responses.front().transfer);
    what_->setText(QCoreApplication::translate("step", step.what));
  }
  arm_->setVisible(figure_ == 0);
  measuring_->setVisible(figure_ == 0);
  what_->setVisible(figure_ != 0);
  static_cast<QBoxLayout*>(layout())->setStretch(0, figure_ == 0 ? 1 : 3);  // a figure leaves the plot more room
  const QSignalBlocker silent_law(law_choice_), silent_figure(figure_choice_);
  law_choice_->setCurrentIndex(static_cast<int>(law_));
  figure_choice_->setCurrentIndex(figure_);
  const bool open = !parts_.document.scene().constraints.empty();
  const scene::Gains gains = open ? control().gains : scene::Gains{};
  const double own[] = {gains.kp_N_per_mm.x(), gains.kd_N_s_per_mm.x(), gains.ki_N_per_mm_s.x(),
                        parts_.arm_in_use.model().mass_kg, parts_.arm_in_use.model().damping_N_s_per_m};
  for (int quantity = 0; quantity < kQuantities; ++quantity) {
    const double unit = quantity <= kKi ? kNewtonPerMetre : 1.0;
    rows_[static_cast<std::size_t>(quantity)]->present(valueOf(quantity) / unit, own[quantity]);
  }
  rows_[kKd]->setVisible(law_ != scene::LawType::P);
  rows_[kKi]->setVisible(law_ == scene::LawType::PID);
  plot_->present(picture);
  refreshTable(picture);
  poles_->setText(picture.responses.empty() ? QString() : polesText(picture.responses.front().transfer));
  note_->setText(note);
}

void StepPanel::refreshTable(const StepPicture& picture) {
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) table_->set(row, column, {});
  }
  const auto tell = [this](int column, const lab::StepMetrics& metrics, const QString& never) {
    table_->set(kFinal, column, figureText(metrics.final_value));
    table_->set(kRise, column, figureText(metrics.rise_10_90_s));
    table_->set(kSettling, column, figureText(metrics.settling_2pct_s, never));
    table_->set(kPeak, column, figureText(metrics.peak_time_s));
    table_->set(kOvershoot, column, figureText(percent(metrics.overshoot_fraction)));
  };
  if (picture.responses.empty()) return;
  const lab::TransferFunction& first = picture.responses.front().transfer;
  tell(kModel, picture.metrics, tr("never"));
  const lab::NaturalMotion motion = figure_ == 0 ? naturalMotion(held_, law_) : naturalMotionOf(first);
  table_->set(kOmega, kModel, figureText(motion.omega_n_rad_per_s));
  table_->set(kZeta, kModel, figureText(motion.zeta));
  if (!picture.measured) return;
  tell(kMeasured, lab::metricsOf(*picture.measured), tr("never"));
  table_->set(kError, kMeasured, figureText(kMillimetrePerMetre * measured_->steady_error_m));
  if (!picture.fit) return;
  lab::StepMetrics fit = lab::metricsOf(lab::secondOrder(picture.fit->omega_n_rad_per_s, picture.fit->zeta));
  fit.final_value = picture.fit->gain;
  tell(kFitted, fit, tr("never"));
  table_->set(kOmega, kFitted, figureText(picture.fit->omega_n_rad_per_s));
  table_->set(kZeta, kFitted, figureText(picture.fit->zeta));
  table_->set(kLeft, kFitted, figureText(kMillimetrePerMetre * picture.fit->residual));
}

void StepPanel::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

}  // namespace underact::gui
