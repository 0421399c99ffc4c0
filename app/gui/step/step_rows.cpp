#include "app/gui/step/step_rows.h"

#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/feature/gain_row.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/panel_form.h"
#include "app/gui/model/setting_words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr const char* kStepRowKeys[] = {"kp", "kd", "ki", "mass", "damping"};

ValueKind stepKind(int quantity) {
  if (quantity == StepRows::kMass)
    return {
        StepRows::tr("Mass at the tip: the apparent mass of the arm, plus that of a hand: m x'' + b x' + kp x = kp r."),
        "kg",
        1000,
        500,
        3,
        100.0};
  if (quantity == StepRows::kDamping)
    return {StepRows::tr("Damping at the tip besides that of the control law: the arm's own, plus that of a hand: "
                         "m x'' + b x' + kp x = kp r."),
            "N s/m",
            10,
            200,
            2,
            1e4};
  return gainValueKind(quantity);
}

}  // namespace

StepRows::StepRows(QWidget* parent) : QWidget(parent), choices_(panelForm()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 4);
  column->setSpacing(4);
  constraint_ = chooser("panel.step.constraint", tr("Measured constraint"),
                        tr("The constraint of the scene that is measured and whose gains are copied."), this);
  law_ = chooser("panel.step.law", tr("Control law of the response"),
                 tr("P: kp e (B.13).  PD: plus kd de/dt (B.14).  PID: plus the integral of ki e (B.15)."), this);
  law_->addItems(settingChoices("/control/law"));
  choices_->addRow(tr("C&onstraint"), constraint_);
  choices_->addRow(tr("La&w"), law_);
  column->addLayout(choices_);
  const QString labels[] = {"kp", "kd", "ki", tr("mass"), tr("b")};
  const QString spoken[] = {tr("Stiffness kp"), tr("Damping kd"), tr("Integral ki"), tr("Mass"), tr("Damping b")};
  for (int quantity = 0; quantity < kQuantities; ++quantity) {
    auto* row = new ValueRow(stepKind(quantity), QString("panel.step.%1").arg(kStepRowKeys[quantity]), this);
    row->setLabel(labels[quantity], spoken[quantity], tr("mass"));
    connect(row, &ValueRow::changed, this,
            [this, quantity](double value, bool) { emit quantityChanged(quantity, value); });
    rows_[static_cast<std::size_t>(quantity)] = row;
    column->addWidget(row);
  }
  connect(law_, &QComboBox::currentIndexChanged, this,
          [this](int row) { emit lawChosen(static_cast<scene::LawType>(row)); });
  connect(constraint_, &QComboBox::currentIndexChanged, this, [this](int row) {
    if (row >= 0) emit constraintChosen(row);
  });
}

double& StepRows::valueOf(lab::HeldMass& held, int quantity) {
  double* const values[] = {&held.kp_N_per_m, &held.kd_N_s_per_m, &held.ki_N_per_m_s, &held.mass_kg,
                            &held.damping_N_s_per_m};
  return *values[quantity];
}

double StepRows::unitOf(int quantity) {
  return quantity <= kKi ? kNewtonPerMetre : 1.0;
}

int StepRows::quantityOf(const QString& key) {
  for (int quantity = 0; quantity < kQuantities; ++quantity) {
    if (key == kStepRowKeys[quantity]) return quantity;
  }
  return -1;
}

void StepRows::list(const std::vector<scene::Constraint>& constraints, std::size_t chosen) {
  const QSignalBlocker silent(constraint_);
  constraint_->clear();
  for (const scene::Constraint& one : constraints) constraint_->addItem(QString::fromStdString(one.name));
  constraint_->setCurrentIndex(static_cast<int>(chosen));
  choices_->setRowVisible(constraint_, constraints.size() > 1);
}

void StepRows::present(const lab::HeldMass& held, scene::LawType law, const lab::HeldMass& own) {
  const QSignalBlocker silent(law_);
  law_->setCurrentIndex(static_cast<int>(law));
  lab::HeldMass shown = held, marked = own;
  for (int quantity = 0; quantity < kQuantities; ++quantity) {
    const double unit = unitOf(quantity);
    rows_[static_cast<std::size_t>(quantity)]->present(valueOf(shown, quantity) / unit,
                                                       valueOf(marked, quantity) / unit);
  }
  rows_[kKd]->setVisible(law != scene::LawType::P);
  rows_[kKi]->setVisible(law == scene::LawType::PID);
}

}  // namespace underact::gui
