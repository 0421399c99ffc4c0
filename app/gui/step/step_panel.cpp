#include "app/gui/step/step_panel.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/arm_in_use.h"
#include "app/gui/model/document.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/step/step_figures.h"
#include "app/gui/step/step_foot.h"
#include "app/gui/step/step_plot.h"
#include "app/gui/step/step_rows.h"
#include "core/base/units.h"
#include "core/lab/thesis_steps.h"
#include "core/scene/edit.h"
#include "core/scene/fields.h"

namespace underact::gui {
namespace {

using lab::Behaviour;

QString sentenceOn(const lab::TransferFunction& transfer) {
  switch (lab::behaviourOf(transfer)) {
    case Behaviour::Grows:
      return StepPanel::tr(
          "The response grows without bound: a pole lies to the right of the imaginary axis, or a double pole on it.");
    case Behaviour::Drifts:
      return StepPanel::tr("The response drifts for ever: a pole lies at 0.");
    case Behaviour::Swings:
      return StepPanel::tr("The response oscillates for ever: there is no damping.");
    case Behaviour::Settles:
      break;
  }
  return {};
}

/// For den = a s^2 + b s + c; NaN for any other degree.
lab::NaturalMotion naturalMotionOf(const lab::TransferFunction& transfer) {
  if (transfer.den.size() != 3) return {kNotANumber, kNotANumber};
  const lab::HeldMass held{transfer.den[0], transfer.den[1], transfer.den[2]};
  return naturalMotion(held, scene::LawType::P);
}

scene::Control withGains(scene::Control control, scene::LawType law, const lab::HeldMass& held) {
  control.law = law;
  control.gains.kp_N_per_mm.setConstant(held.kp_N_per_m / kNewtonPerMetre);
  control.gains.kd_N_s_per_mm.setConstant(held.kd_N_s_per_m / kNewtonPerMetre);
  control.gains.ki_N_per_mm_s.setConstant(held.ki_N_per_m_s / kNewtonPerMetre);
  return control;
}

}  // namespace

StepPanel::StepPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  held_.kp_N_per_m = 500.0;
  build();
  connectParts();
  takeArm();
  addCommands();
  sceneOpened();
}

void StepPanel::build() {
  auto* outer = tight<QVBoxLayout>(this, 0);
  outer->addWidget(plot_ = new StepPlot(this), 1);  // stays visible while the rest scrolls
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  figure_choice_ = chooser("panel.step.figure", tr("Response shown"),
                           tr("The arm under a control law, or one of the figures in appendix B of the thesis."), this);
  figure_choice_->addItem(tr("The arm under a control law"));
  for (const lab::ThesisStep& step : lab::thesisSteps())
    figure_choice_->addItem(tr("%1  %2").arg(QString(step.key), QCoreApplication::translate("step", step.title)));
  column->addWidget(figure_choice_);
  column->addWidget(what_ = quietLabel("panel.step.what", {}, content));
  column->addWidget(rows_ = new StepRows(content));
  column->addWidget(figures_ = new StepFigures(content));
  column->addStretch(1);
  QScrollArea* scroll = panelScroll(content, this);
  scroll->setMinimumWidth(content->minimumSizeHint().width() + 16);
  outer->addWidget(scroll, 2);
  // Below the scroll area: a note is always visible, and does not move a slider from under the pointer when it appears.
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(8, 4, 8, 8);
  foot->setSpacing(4);
  note_ = quietLabel("panel.step.note", {}, this);
  note_->setAccessibleName(tr("Notes on this response"));
  foot->addWidget(note_);
  foot->addWidget(foot_ = new StepFoot(this));
  outer->addLayout(foot);
}

void StepPanel::connectParts() {
  connect(figure_choice_, &QComboBox::currentIndexChanged, this, &StepPanel::showFigure);
  connect(rows_, &StepRows::quantityChanged, this, &StepPanel::setQuantity);
  connect(rows_, &StepRows::lawChosen, this, &StepPanel::setLaw);
  connect(rows_, &StepRows::constraintChosen, this, [this](int row) {
    index_ = static_cast<std::size_t>(row);
    measured_.reset();
    refresh();
  });
  connect(foot_, &StepFoot::takeAsked, this, &StepPanel::takeFromScene);
  connect(foot_, &StepFoot::giveAsked, this, &StepPanel::giveToScene);
  connect(foot_, &StepFoot::measureAsked, this, &StepPanel::measure);
  connect(&parts_.document, &Document::opened, this, &StepPanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &StepPanel::sceneEdited);
  connect(&parts_.arm_in_use, &ArmInUse::changed, this, &StepPanel::takeArm);
  connect(&parts_.rate, &ServoRate::changed, this, [this] {  // measured at another rate
    measured_.reset();
    refresh();
  });
}

void StepPanel::addCommands() {
  parts_.actions.addCommand("step.show", [this](const QVariantList& values) {  // 0: the arm; 1 to 5: B.1 to B.5
    const int figure = values.value(0, -1).toInt();
    if (figure < 0 || figure >= figure_choice_->count()) return false;
    figure_choice_->setCurrentIndex(figure);
    return true;
  });
  parts_.actions.addCommand("step.law", [this](const QVariantList& values) {
    for (const auto& law : scene::kLawWords) {
      if (values.value(0).toString() == law.word) return setLaw(law.value);
    }
    return false;
  });
  parts_.actions.addCommand("step.set", [this](const QVariantList& values) {
    const int quantity = StepRows::quantityOf(values.value(0).toString());
    return quantity >= 0 && setQuantity(quantity, values.value(1).toDouble());
  });
  parts_.actions.addCommand("step.take", [this](const QVariantList&) { return takeFromScene(); });
  parts_.actions.addCommand("step.give", [this](const QVariantList&) { return giveToScene(); });
  parts_.actions.addCommand("step.measure", [this](const QVariantList&) { return measure(); });
}

const scene::Control& StepPanel::control() const {
  return scene::controlOf(parts_.document.scene(), index_);
}

/// Sets the sliders of mass and damping to the arm's values.
void StepPanel::takeArm() {
  held_.mass_kg = parts_.arm_in_use.model().mass_kg;
  held_.damping_N_s_per_m = parts_.arm_in_use.model().damping_N_s_per_m;
  measured_.reset();
  refresh();
}

void StepPanel::listConstraints() {
  const std::vector<scene::Constraint>& constraints = parts_.document.scene().constraints;
  if (index_ >= constraints.size()) index_ = 0;
  rows_->list(constraints, index_);
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
  StepRows::valueOf(held_, quantity) = StepRows::unitOf(quantity) * value;
  measured_.reset();
  refresh();
  return true;
}

lab::HeldMass StepPanel::own() const {
  const bool open = !parts_.document.scene().constraints.empty();
  const scene::Gains gains = open ? control().gains : scene::Gains{};
  lab::HeldMass own;
  own.kp_N_per_m = kNewtonPerMetre * gains.kp_N_per_mm.x();
  own.kd_N_s_per_m = kNewtonPerMetre * gains.kd_N_s_per_mm.x();
  own.ki_N_per_m_s = kNewtonPerMetre * gains.ki_N_per_mm_s.x();
  own.mass_kg = parts_.arm_in_use.model().mass_kg;
  own.damping_N_s_per_m = parts_.arm_in_use.model().damping_N_s_per_m;
  return own;
}

bool StepPanel::takeFromScene() {
  if (parts_.document.scene().constraints.empty()) return false;
  const lab::HeldMass gains = own();
  law_ = control().law;
  held_.kp_N_per_m = gains.kp_N_per_m;
  held_.kd_N_s_per_m = gains.kd_N_s_per_m;
  held_.ki_N_per_m_s = gains.ki_N_per_m_s;
  measured_.reset();
  refresh();
  return true;
}

bool StepPanel::giveToScene() {
  if (parts_.document.scene().constraints.empty()) return false;
  const scene::Description edited = withControl(parts_.document.scene(), index_, withGains(control(), law_, held_));
  const Problems problems =
      parts_.document.edit(edited, tr("gains of the step response"), parts_.document.newGesture());
  if (!problems.empty()) note_->setText(sentencesOf(problems));
  return problems.empty();
}

// In the window's thread: 20,000 ticks, the maximum, take half a second, so no cancelling is needed.
bool StepPanel::measure() {
  const scene::Description& scene = parts_.document.scene();
  if (scene.constraints.empty()) return false;
  lab::StepSetup setup;
  setup.step_m = kMetrePerMillimetre * foot_->step_mm();
  setup.constraint = scene.constraints[index_].name;
  setup.arm = parts_.arm_in_use.model();
  setup.arm.mass_kg = held_.mass_kg;
  setup.arm.damping_N_s_per_m = held_.damping_N_s_per_m;  // includes a hand's, which acts like the arm's own
  setup.rate_hz = parts_.servo.rateHz();
  setup.limits = foot_->hasLimits();
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
  picture.seconds = lab::plotDuration_s(transfer.value());
  note = sentenceOn(transfer.value());
  if (!measured_) return picture;
  lab::SampledResponse share = measured_->travel_m;
  for (double& value : share.value) value /= measured_->step_m;
  const double length_s = share.period_s * static_cast<double>(share.value.size() - 1);
  const double rest_s = measured_->measured.settling_2pct_s.value_or(0.0);
  if (picture.metrics.settling_2pct_s)
    picture.seconds = std::max(picture.seconds, 1.5 * rest_s);
  else
    picture.seconds = rest_s > 0.0 ? 1.5 * rest_s : length_s;
  picture.measured = std::move(share);
  picture.steady_error_m = measured_->steady_error_m;
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
    return tr("The tip did not move: %1 N does not overcome the arm's friction of %2 N. Make the step larger.")
        .arg(numberText(pull_N, 2))
        .arg(numberText(step.friction_N, 2));
  if (step.limited_ticks > 0)
    return tr("The safety gate reduced the force in %1 ticks, so the response is not linear. Make the step smaller, or "
              "measure without the limits.")
        .arg(step.limited_ticks);
  const QString arm = QString::fromStdString(parts_.arm_in_use.model().name);
  return tr("Measured along %1%3. The model has no friction; the arm has %2 N.")
      .arg(step.axis == lab::Axis::Held ? tr("the direction in which the constraint pulls") : QString(name(step.axis)))
      .arg(numberText(step.friction_N, 2))
      .arg(parts_.arm_in_use.isMeasured() ? tr(" on “%1”").arg(arm) : QString());
}

void StepPanel::refresh() {
  is_stale_ = !isVisible();
  if (is_stale_) return;  // nobody sees it: the response is computed when the panel is opened
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
  rows_->setVisible(figure_ == 0);
  foot_->setVisible(figure_ == 0);
  what_->setVisible(figure_ != 0);
  static_cast<QBoxLayout*>(layout())->setStretch(0, figure_ == 0 ? 1 : 3);  // a figure leaves the plot more room
  const QSignalBlocker silent(figure_choice_);
  figure_choice_->setCurrentIndex(figure_);
  rows_->present(held_, law_, own());
  plot_->present(picture);
  const bool has_first = figure_ != 0 && !picture.responses.empty();
  figures_->present(picture,
                    has_first ? naturalMotionOf(picture.responses.front().transfer) : naturalMotion(held_, law_));
  note_->setText(note);
}

void StepPanel::showEvent(QShowEvent* event) {
  Panel::showEvent(event);
  if (is_stale_) refresh();
}

void StepPanel::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

}  // namespace underact::gui
