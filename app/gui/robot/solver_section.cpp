#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "app/gui/arms/joint_fields.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/model/setting_words.h"
#include "app/gui/robot/sections.h"

namespace underact::gui {
namespace {

/// The wheel scrolls the panel until the number has the focus.
class StepsBox : public QSpinBox {
 public:
  using QSpinBox::QSpinBox;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus())
      QSpinBox::wheelEvent(event);
    else
      event->ignore();
  }
};

}  // namespace

SolverSection::SolverSection(QWidget* parent)
    : Section("solver", tr("Solver"),
              tr("How the joints of least energy are found, every tick. Nothing felt changes with the method."), parent,
              "robot"),
      method_(
          chooser("panel.robot.method", tr("Method of the solver"), settingTip("/constraints/*/solver/method"), this)),
      steps_(new StepsBox(this)),
      tolerance_(new QLineEdit(this)) {
  method_->addItems({tr("by itself (auto)"), tr("closed form"), tr("iterative")});
  steps_->setObjectName("panel.robot.max_steps");
  steps_->setAccessibleName(tr("Most steps a tick"));
  steps_->setToolTip(settingTip("/constraints/*/solver/max_steps"));
  steps_->setRange(1, 100);
  steps_->setKeyboardTracking(false);
  steps_->setFocusPolicy(Qt::StrongFocus);
  tolerance_->setObjectName("panel.robot.tolerance");
  tolerance_->setAccessibleName(tr("Tolerance, rad and shares of the reach"));
  tolerance_->setToolTip(settingTip("/constraints/*/solver/tolerance"));
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Method"), method_);
  form->addRow(tr("Most steps"), steps_);
  form->addRow(tr("Tolerance"), tolerance_);
  column().addLayout(form);
  connect(method_, &QComboBox::currentIndexChanged, this,
          [this](int row) { emit methodAsked(static_cast<scene::SolverMethod>(row)); });
  connect(steps_, &QSpinBox::valueChanged, this, &SolverSection::stepsAsked);
  connect(tolerance_, &QLineEdit::editingFinished, this, [this] {
    if (!tolerance_->isModified()) return;
    tolerance_->setModified(false);
    emit toleranceAsked(tolerance_->text());
  });
}

void SolverSection::present(const scene::Solver& solver) {
  const QSignalBlocker silent_method(method_), silent_steps(steps_);
  method_->setCurrentIndex(static_cast<int>(solver.method));
  steps_->setValue(solver.max_steps);
  tolerance_->setText(exactNumber(solver.tolerance));
}

}  // namespace underact::gui
