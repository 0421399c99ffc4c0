#include "app/gui/calibration/begin_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/tight_layout.h"

namespace underact::gui {

BeginPage::BeginPage(QWidget* parent)
    : QWidget(parent),
      reference_(new NumberBox(this)),
      who_(new QComboBox(this)),
      weber_(new NumberBox(this)),
      seed_(new QSpinBox(this)),
      feedback_(new QCheckBox(tr("Sho&w feedback"), this)),
      note_(quietLabel("panel.calibration.note", {}, this)) {
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
  auto* begin_button = new QPushButton(tr("&Begin"), this);
  nameWidget(begin_button, "panel.calibration.begin", tr("Begin the measurement"),
             tr("Starts the trials. Two right answers in a row make them harder, a wrong one easier (Levitt 1971)."));
  auto* column = tight<QVBoxLayout>(this, 8);
  column->addWidget(quietLabel("panel.calibration.about",
                               tr("How small a difference of stiffness can be felt (just-noticeable difference, JND)? "
                                  "Press two beams and answer which one is stiffer, again and again."),
                               this));
  column->addLayout(form);
  column->addWidget(feedback_);
  column->addWidget(begin_button);
  column->addWidget(note_);
  column->addStretch(1);
  note_->hide();
  connect(begin_button, &QPushButton::clicked, this, &BeginPage::begin);
  connect(who_, &QComboBox::currentIndexChanged, this, &BeginPage::showWho);
  showWho();
}

void BeginPage::addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& key,
                       const QString& tip) {
  nameWidget(field, "panel.calibration." + key, QString(label).remove('&'), tip);
  field->setFocusPolicy(Qt::StrongFocus);  // the wheel scrolls the panel
  auto* name = new QLabel(label, this);
  name->setToolTip(tip);
  name->setBuddy(field);
  form->addRow(name, field);
}

void BeginPage::showWho() {
  const bool person = setup().who == Answering::Person;
  weber_->setEnabled(!person);
  feedback_->setEnabled(person);
}

void BeginPage::setReference(double reference_N_per_mm) {
  own_N_per_mm_ = reference_N_per_mm;
  reference_->setValue(reference_N_per_mm);
}

void BeginPage::setNote(const QString& note) {
  showMessage(note_, note);
}

CalibrationSetup BeginPage::setup() const {
  const bool untouched = reference_->value() == QString::number(own_N_per_mm_, 'f', reference_->decimals()).toDouble();
  return {untouched ? own_N_per_mm_ : reference_->value(),
          who_->currentIndex() == 0 ? Answering::Person : Answering::SimulatedHand, weber_->value() / 100.0,
          static_cast<std::uint64_t>(seed_->value())};
}

bool BeginPage::saysWhetherRight() const {
  return feedback_->isChecked() && setup().who == Answering::Person;
}

void BeginPage::remember() const {
  QSettings stored;
  stored.setValue("calibration/simulated", who_->currentIndex() == 1);
  stored.setValue("calibration/weber_percent", weber_->value());
  stored.setValue("calibration/seed", seed_->value());
  stored.setValue("calibration/say_right", feedback_->isChecked());
}

}  // namespace underact::gui
