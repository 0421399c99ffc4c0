#include "app/gui/lab/measuring_part.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStyle>
#include <QVBoxLayout>

#include "app/gui/kit/chooser.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/panel_form.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"
#include "core/sim/hand_script.h"

namespace underact::gui {
namespace {

constexpr int kProgressSteps = 1000;

}  // namespace

MeasuringPart::MeasuringPart(QWidget* parent) : QWidget(parent) {
  auto* column = tight<QVBoxLayout>(this, 4);
  hands_ = chooser("panel.lab.hands", tr("Hands that move the stylus"),
                   tr("Which simulated hands move the stylus during the measurement."), this);
  hands_->addItem(tr("All hands"), "");
  for (const sim::BuiltInHand& one : sim::builtInHands()) hands_->addItem(one.name, one.name);
  seconds_ = new QSpinBox(this);
  seconds_->setObjectName("panel.lab.seconds");
  seconds_->setAccessibleName(tr("Length of each run, s"));
  seconds_->setToolTip(tr("How long each run is, in simulated time."));
  seconds_->setRange(2, 4);
  seconds_->setSuffix(tr(" s each"));
  seconds_->setFocusPolicy(Qt::StrongFocus);
  measure_ = pushButton("panel.lab.measure", tr("&Measure"),
                        tr("Measures cost and error of every choice for this scene, and finds the best trade-offs."),
                        this, tr("Measure speed and accuracy of this scene"));
  cancel_ = pushButton("panel.lab.cancel", tr("Cancel"), tr("Ends the measurement; nothing is kept."), this,
                       tr("Cancel the measurement"));
  progress_ = new QProgressBar(this);
  progress_->setObjectName("panel.lab.progress");
  progress_->setAccessibleName(tr("Progress of the measurement"));
  progress_->setRange(0, kProgressSteps);
  told_ = messageLabel("panel.lab.told", tr("Status of the measurement"), "quiet", this);
  auto* form = panelForm();
  form->addRow(tr("&Hands"), hands_);
  form->addRow(tr("R&uns"), seconds_);
  auto* row = new QHBoxLayout;
  row->addWidget(measure_, 1);
  row->addWidget(cancel_);
  column->addLayout(form);
  column->addLayout(row);
  column->addWidget(progress_);
  column->addWidget(told_);
  connect(measure_, &QPushButton::clicked, this, &MeasuringPart::measureAsked);
  connect(cancel_, &QPushButton::clicked, this, &MeasuringPart::cancelAsked);
  connect(hands_, &QComboBox::currentIndexChanged, this, &MeasuringPart::changed);
  connect(seconds_, &QSpinBox::valueChanged, this, &MeasuringPart::changed);
}

std::string MeasuringPart::hand() const {
  return hands_->currentData().toString().toStdString();
}

std::size_t MeasuringPart::handCount() const {
  return static_cast<std::size_t>(hands_->currentIndex() == 0 ? hands_->count() - 1 : 1);
}

double MeasuringPart::seconds() const {
  return seconds_->value();
}

void MeasuringPart::setShare(double share) {
  progress_->setValue(static_cast<int>(share * progress_->maximum()));
}

void MeasuringPart::setBusy(bool is_busy, bool can_measure) {
  measure_->setEnabled(can_measure && !is_busy);
  hands_->setEnabled(!is_busy);
  seconds_->setEnabled(!is_busy);
  progress_->setVisible(is_busy);
  cancel_->setVisible(is_busy);
}

void MeasuringPart::tell(const QString& sentence, bool alarm) {
  told_->setText(sentence);
  told_->setProperty("role", alarm ? "amber" : "quiet");
  told_->style()->polish(told_);
}

}  // namespace underact::gui
