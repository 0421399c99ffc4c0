// How the Step response panel is put together; what it does is in step_panel.cpp.
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/feature/gain_row.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/model/setting_words.h"
#include "app/gui/step/step_panel.h"
#include "app/gui/step/step_plot.h"
#include "core/lab/thesis_steps.h"

namespace underact::gui {
namespace {

constexpr const char* kKeys[] = {"kp", "kd", "ki", "mass", "damping"};
}  // namespace

void StepPanel::build() {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(0);
  outer->addWidget(plot_ = new StepPlot(this), 1);  // stays in sight while what is below it scrolls
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  figure_choice_ = chooser("panel.step.figure", tr("What is shown"),
                           tr("The arm under a law, or one of the figures of the thesis's appendix B."), this);
  figure_choice_->addItem(tr("The arm under a law"));
  for (const lab::ThesisStep& step : lab::thesisSteps())
    figure_choice_->addItem(tr("%1  %2").arg(QString(step.key), QCoreApplication::translate("step", step.title)));
  column->addWidget(figure_choice_);
  column->addWidget(what_ = quietLabel("panel.step.what", {}, content));
  arm_ = new QWidget(content);
  auto* arm = new QVBoxLayout(arm_);
  arm->setContentsMargins(0, 0, 0, 4);
  arm->setSpacing(4);
  buildRows(arm);
  column->addWidget(arm_);
  table_ =
      new NumberTable("panel.step.table",
                      {{tr("model"), "000.0000"}, {tr("measured"), "000.0000"}, {tr("its fit"), "000.0000"}}, content);
  table_->addRow(tr("Final value"), tr("Where it ends, a share of the step; of an undamped one what it swings about."));
  table_->addRow(tr("Rise [s]"), tr("From 10 % of the final value to 90 %, each first passed."));
  table_->addRow(tr("Settling [s]"), tr("From then on it stays within 2 % of the final value."));
  table_->addRow(tr("Peak [s]"), tr("When it is highest, where it goes beyond the final value."));
  table_->addRow(tr("Overshoot [%]"), tr("How far it goes beyond: exp(−π ζ / √(1 − ζ²)) of a second order."));
  table_->addRow(tr("ωₙ [rad/s]"), tr("Natural frequency: √(kp / m)."));
  table_->addRow(tr("ζ"), tr("Damping ratio: (b + kd) / (2 √(kp m)); 1 is critical."));
  table_->addRow(tr("Error [mm]"), tr("Steady error: from the target to where the tip stands at the end. Friction can "
                                      "hold it up to friction / kp away."));
  table_->addRow(tr("Left [mm]"), tr("What the fit leaves of the measured curve, root of the mean square."));
  column->addWidget(table_);
  column->addWidget(poles_ = quietLabel("panel.step.poles", {}, content));
  column->addStretch(1);
  QScrollArea* scroll = panelScroll(content, this);
  scroll->setMinimumWidth(content->minimumSizeHint().width() + 16);
  outer->addWidget(scroll, 2);
  // Below what scrolls: a sentence is always seen, and its coming moves no slider from under the pointer.
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(8, 4, 8, 8);
  foot->setSpacing(4);
  note_ = quietLabel("panel.step.note", {}, this);
  note_->setAccessibleName(tr("What there is to know of this response"));
  foot->addWidget(note_);
  measuring_ = new QWidget(this);
  buildMeasuring(measuring_);
  foot->addWidget(measuring_);
  outer->addLayout(foot);
  connect(figure_choice_, &QComboBox::currentIndexChanged, this, &StepPanel::showFigure);
}

void StepPanel::buildRows(QVBoxLayout* column) {
  choices_ = new QFormLayout;
  choices_->setHorizontalSpacing(12);
  choices_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  constraint_ = chooser("panel.step.constraint", tr("Constraint that is measured"),
                        tr("Which constraint of the scene is measured, and whose gains are taken and given."), this);
  law_choice_ = chooser("panel.step.law", tr("Law of the response"),
                        tr("P: kp e (B.13).  PD: and kd de/dt (B.14).  PID: and the integral of ki e (B.15)."), this);
  law_choice_->addItems({tr("P, proportional"), tr("PD, with damping"), tr("PID, with integral")});
  choices_->addRow(tr("C&onstraint"), constraint_);
  choices_->addRow(tr("La&w"), law_choice_);
  column->addLayout(choices_);
  const auto kindOf = [this](int quantity) -> ValueKind {
    if (quantity == kMass)
      return {tr("What moves at the tip: the arm's apparent mass, and a hand's: m x'' + b x' + kp x = kp r."),
              "kg",
              1000,
              500,
              3,
              100.0};
    if (quantity == kDamping)
      return {tr("What slows the tip besides the law, the arm's own damping and a hand's: m x'' + b x' + kp x = kp r."),
              "N s/m",
              10,
              200,
              2,
              1e4};
    const GainKind& gain = gainKind(quantity);
    return {settingTip(gain.path), QString(gain.unit), gain.steps_per_unit, gain.slider_steps, gain.decimals, 1e6};
  };
  const QString labels[] = {"kp", "kd", "ki", tr("mass"), tr("b")};
  const QString spoken[] = {tr("Stiffness kp"), tr("Damping kd"), tr("Integral ki"), tr("Mass"), tr("Damping b")};
  for (int quantity = 0; quantity < kQuantities; ++quantity) {
    auto* row = new ValueRow(kindOf(quantity), QString("panel.step.%1").arg(kKeys[quantity]), this);
    row->setLabel(labels[quantity], spoken[quantity], tr("mass"));
    connect(row, &ValueRow::changed, this, [this, quantity](double value, bool) { setQuantity(quantity, value); });
    rows_[static_cast<std::size_t>(quantity)] = row;
    column->addWidget(row);
  }
  connect(law_choice_, &QComboBox::currentIndexChanged, this,
          [this](int row) { setLaw(static_cast<scene::LawType>(row)); });
  connect(constraint_, &QComboBox::currentIndexChanged, this, [this](int row) {
    if (row < 0) return;
    index_ = static_cast<std::size_t>(row);
    measured_.reset();
    refresh();
  });
}

void StepPanel::buildMeasuring(QWidget* foot) {
  auto* take = pushButton("panel.step.take", tr("&Take gains"),
                          tr("Law and gains of the scene, those along x, into this panel."), this,
                          tr("Take gains from the scene"));
  auto* give = pushButton("panel.step.give", tr("&Give gains"),
                          tr("Law and gains of this panel into the scene, along x, y and z; one step back undoes it."),
                          this, tr("Give gains to the scene"));
  auto* measuring =
      pushButton("panel.step.measure", tr("&Measure the arm"),
                 tr("Moves the target of the scene's constraint by a step, on a simulated arm of its own with "
                    "these gains, and lays the tip's way over the model's. Nobody holds the stylus."),
                 this, tr("Measure the simulated arm"));
  step_mm_ = new NumberBox(this);
  step_mm_->setObjectName("panel.step.size");
  step_mm_->setAccessibleName(tr("Length of the step, mm"));
  step_mm_->setToolTip(tr("How far the target is moved for the measurement."));
  step_mm_->setDecimals(2);
  step_mm_->setRange(0.1, 100.0);
  step_mm_->setValue(10.0);
  step_mm_->setSuffix(tr(" mm"));
  step_mm_->setKeyboardTracking(false);
  step_mm_->setFocusPolicy(Qt::StrongFocus);
  limits_ = new QCheckBox(tr("With the &limits of the gate"), this);
  limits_->setObjectName("panel.step.limits");
  limits_->setAccessibleName(tr("With the limits of the gate"));
  limits_->setToolTip(
      tr("The force is cut to what the arm bears, and to a speed. Off: the law alone, as the model has it."));
  limits_->setChecked(true);
  auto* grid = new QGridLayout(foot);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  grid->addWidget(take, 0, 0);
  grid->addWidget(give, 0, 1);
  grid->addWidget(step_mm_, 1, 0);
  grid->addWidget(measuring, 1, 1);
  grid->addWidget(limits_, 2, 0, 1, 2);
  connect(take, &QPushButton::clicked, this, &StepPanel::takeFromScene);
  connect(give, &QPushButton::clicked, this, &StepPanel::giveToScene);
  connect(measuring, &QPushButton::clicked, this, &StepPanel::measure);
}

void StepPanel::addCommands() {
  parts_.actions.addCommand("step.show", [this](const QVariantList& values) {  // 0: the arm; 1 to 5: B.1 to B.5
    const int figure = values.value(0, -1).toInt();
    if (figure < 0 || figure >= figure_choice_->count()) return false;
    figure_choice_->setCurrentIndex(figure);
    return true;
  });
  parts_.actions.addCommand("step.law", [this](const QVariantList& values) {
    const auto law = static_cast<int>(QStringList{"P", "PD", "PID"}.indexOf(values.value(0).toString()));
    return law >= 0 && setLaw(static_cast<scene::LawType>(law));
  });
  parts_.actions.addCommand("step.set", [this](const QVariantList& values) {
    for (int quantity = 0; quantity < kQuantities; ++quantity) {
      if (values.value(0).toString() == kKeys[quantity]) return setQuantity(quantity, values.value(1).toDouble());
    }
    return false;
  });
  parts_.actions.addCommand("step.take", [this](const QVariantList&) { return takeFromScene(); });
  parts_.actions.addCommand("step.give", [this](const QVariantList&) { return giveToScene(); });
  parts_.actions.addCommand("step.measure", [this](const QVariantList&) { return measure(); });
}

}  // namespace underact::gui
