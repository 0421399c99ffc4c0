#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "app/gui/calibration/calibration_panel.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/words.h"

namespace underact::gui {

ProcedurePage* CalibrationPanel::beginPage() {
  ProcedurePage* const page = addPage();
  reference_ = new NumberBox(page);
  who_ = new QComboBox(page);
  weber_ = new NumberBox(page);
  seed_ = new QSpinBox(page);
  feedback_ = new QCheckBox(tr("Sho&w feedback"), page);
  refusal_ = quietLabel("panel.calibration.note", {}, page);
  reference_->setDecimals(4);
  reference_->setRange(0.005, 0.2);
  reference_->setSingleStep(0.005);
  reference_->setSuffix(tr(" N/mm"));
  who_->addItems({tr("a person"), tr("simulated hand")});
  weber_->setDecimals(1);
  weber_->setRange(0.0, 100.0);
  weber_->setSuffix(tr(" %"));
  seed_->setRange(0, 999'999);
  const QSettings stored;
  who_->setCurrentIndex(stored.value("calibration/simulated", false).toBool() ? 1 : 0);
  weber_->setValue(stored.value("calibration/weber_percent", 15.0).toDouble());
  seed_->setValue(stored.value("calibration/seed", 1).toInt());
  feedback_->setChecked(stored.value("calibration/say_right", false).toBool());

  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->setSpacing(8);
  addRow(form, tr("&Reference"), reference_, "reference",
         tr("Stiffness of the softer beam of every trial, at its tip: k = K / L². The other one is stiffer."));
  addRow(form, tr("&Answered by"), who_, "who",
         tr("Who presses the beams and answers which one is stiffer: a person, or a simulated hand."));
  addRow(form, tr("&Weber fraction"), weber_, "weber",
         tr("Scatter of what the simulated hand feels, as a fraction of the stiffness (Weber's law)."));
  addRow(form, tr("See&d"), seed_, "seed",
         tr("Determines the stiffer side of each trial and the scatter of the simulated hand. The same seed gives the "
            "same sequence."));
  nameWidget(feedback_, "panel.calibration.feedback", tr("Show feedback: whether each answer was right"),
             tr("Tells you after each answer whether it was right. For practice only: feedback lets you learn."));
  auto* begin_button = page->button(
      "panel.calibration.begin", tr("&Begin"),
      tr("Starts the trials. Two right answers in a row make them harder, a wrong one easier (Levitt 1971)."),
      tr("Begin the measurement"));
  QVBoxLayout* const column = page->column();
  column->addWidget(quietLabel("panel.calibration.about",
                               tr("How small a difference of stiffness can be felt (just-noticeable difference, JND)? "
                                  "Press two beams and answer which one is stiffer, again and again."),
                               page));
  column->addLayout(form);
  column->addWidget(feedback_);
  column->addWidget(begin_button);
  column->addWidget(refusal_);
  column->addStretch(1);
  refusal_->hide();
  connect(begin_button, &QPushButton::clicked, this, &CalibrationPanel::begin);
  connect(who_, &QComboBox::currentIndexChanged, this, &CalibrationPanel::showWho);
  showWho();
  return page;
}

void CalibrationPanel::addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& key,
                              const QString& tip) {
  nameWidget(field, "panel.calibration." + key, QString(label).remove('&'), tip);
  field->setFocusPolicy(Qt::StrongFocus);  // the wheel scrolls the panel
  auto* name = new QLabel(label, field->parentWidget());
  name->setToolTip(tip);
  name->setBuddy(field);
  form->addRow(name, field);
}

void CalibrationPanel::showWho() {
  const bool person = setup().who == Answering::Person;
  weber_->setEnabled(!person);
  feedback_->setEnabled(person);
}

CalibrationSetup CalibrationPanel::setup() const {
  const bool untouched = reference_->value() == QString::number(own_N_per_mm_, 'f', reference_->decimals()).toDouble();
  return {untouched ? own_N_per_mm_ : reference_->value(),
          who_->currentIndex() == 0 ? Answering::Person : Answering::SimulatedHand, weber_->value() / 100.0,
          static_cast<std::uint64_t>(seed_->value())};
}

bool CalibrationPanel::begin() {
  const bool had_focus = begin_->isAncestorOf(focusWidget());
  const Problems problems = session_->begin(setup());
  if (!problems.empty()) {
    showMessage(refusal_, sentencesOf(problems));
    return false;
  }
  QSettings stored;
  stored.setValue("calibration/simulated", who_->currentIndex() == 1);
  stored.setValue("calibration/weber_percent", weber_->value());
  stored.setValue("calibration/seed", seed_->value());
  stored.setValue("calibration/say_right", feedback_->isChecked());
  if (had_focus) run_->setFocus();  // for the arrow keys
  return true;
}

}  // namespace underact::gui
