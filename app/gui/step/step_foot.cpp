#include "app/gui/step/step_foot.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QPushButton>

#include "app/gui/kit/number_box.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"

namespace underact::gui {

StepFoot::StepFoot(QWidget* parent)
    : QWidget(parent), step_mm_(new NumberBox(this)), limits_(new QCheckBox(tr("&Limits of the safety gate"), this)) {
  auto* take = pushButton("panel.step.take", tr("Ge&t gains"),
                          tr("Copies the control law and the gains along x from the scene to this panel."), this,
                          tr("Get gains from the scene"));
  auto* give =
      pushButton("panel.step.give", tr("Apply &gains"),
                 tr("Copies the control law and the gains of this panel to the scene, for x, y and z; one undo step."),
                 this, tr("Apply gains to the scene"));
  auto* measuring = pushButton("panel.step.measure", tr("&Measure the arm"),
                               tr("Moves the target of the constraint by a step, on a simulated arm of its own with "
                                  "these gains and no hand, and plots the path of the tip over the model's response."),
                               this, tr("Measure the simulated arm"));
  step_mm_->setObjectName("panel.step.size");
  step_mm_->setAccessibleName(tr("Size of the step, mm"));
  step_mm_->setToolTip(tr("How far the target jumps in the measurement."));
  step_mm_->setDecimals(2);
  step_mm_->setRange(0.1, 100.0);
  step_mm_->setValue(10.0);
  step_mm_->setSuffix(tr(" mm"));
  step_mm_->setKeyboardTracking(false);
  step_mm_->setFocusPolicy(Qt::StrongFocus);
  limits_->setObjectName("panel.step.limits");
  limits_->setAccessibleName(tr("Limits of the safety gate"));
  limits_->setToolTip(tr(
      "Measures with the limits of the safety gate on force and speed. Off: the control law alone, as in the model."));
  limits_->setChecked(true);
  auto* grid = tight<QGridLayout>(this, 4);
  grid->addWidget(take, 0, 0);
  grid->addWidget(give, 0, 1);
  grid->addWidget(step_mm_, 1, 0);
  grid->addWidget(measuring, 1, 1);
  grid->addWidget(limits_, 2, 0, 1, 2);
  connect(take, &QPushButton::clicked, this, &StepFoot::takeAsked);
  connect(give, &QPushButton::clicked, this, &StepFoot::giveAsked);
  connect(measuring, &QPushButton::clicked, this, &StepFoot::measureAsked);
}

double StepFoot::step_mm() const {
  return step_mm_->value();
}

bool StepFoot::hasLimits() const {
  return limits_->isChecked();
}

}  // namespace underact::gui
