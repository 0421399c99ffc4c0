#include "app/gui/calibration/result_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/calibration/staircase_chart.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/readout.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

enum Row { kJnd, kRange, kStiffness, kReference, kTrials, kScatter, kWho };

QString percent(double share) {
  return QObject::tr("%1 %").arg(numberText(100.0 * share, 1));
}

}  // namespace

ResultPage::ResultPage(QWidget* parent)
    : QWidget(parent),
      numbers_(new Readout("panel.calibration.result", this)),
      none_(quietLabel(
          "panel.calibration.none",
          tr("No threshold: there were fewer than four reversals, because every difference was felt, or none was."),
          this)),
      note_(quietLabel("panel.calibration.saved", {}, this)),
      chart_(staircaseChart(this)) {
  numbers_->layout()->setContentsMargins(0, 0, 0, 0);
  numbers_->addRow(tr("JND"), tr("Just-noticeable difference: the difference at which 70.7 % of answers are right "
                                 "(Levitt 1971). Geometric mean of the reversals after the first two."));
  numbers_->addRow(tr("± 1 s.d."), tr("One standard deviation of the reversals' logarithms, either way."));
  numbers_->addRow(tr("in stiffness"), tr("The just-noticeable difference times the reference."));
  numbers_->addRow(tr("Reference"), tr("The stiffness of the softer beam of every trial, at its tip."));
  numbers_->addRow(tr("Trials"), tr("Number of answers given."));
  numbers_->addRow(tr("Weber fraction"),
                   tr("Scatter w of a single press that gives this JND when two are compared: ln(1 + JND) = 0.771 w."));
  numbers_->addRow(tr("Answered by"), tr("A person, or the simulated hand with the Weber fraction that was set."));
  auto* save = new QPushButton(tr("&Save…"), this);
  nameWidget(save, "panel.calibration.save", tr("Save the trials"),
             tr("Writes every trial and the result as a CSV file."));
  auto* again = new QPushButton(tr("A&gain"), this);
  nameWidget(again, "panel.calibration.again", tr("Measure again"),
             tr("Returns to the start. A result that was not saved is lost."));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addWidget(save);
  buttons->addWidget(again);
  auto* column = tight<QVBoxLayout>(this, 8);
  column->addWidget(none_);
  column->addWidget(numbers_);
  column->addWidget(chart_, 1);
  column->addLayout(buttons);
  column->addWidget(note_);
  connect(save, &QPushButton::clicked, this, &ResultPage::save);
  connect(again, &QPushButton::clicked, this, &ResultPage::again);
}

void ResultPage::present(const CalibrationRun& session) {
  const calibration::Measurement& run = session.run();
  const auto threshold = thresholdOf(run.staircase);
  none_->setVisible(!threshold);
  const auto set = [&](Row row, const QString& text) { numbers_->set(row, threshold ? text : QString(QChar(0x2013))); };
  const calibration::Threshold found = threshold.value_or(calibration::Threshold{});
  set(kJnd, percent(found.difference));
  set(kRange, tr("%1 to %2").arg(percent(found.low), percent(found.high)));
  set(kStiffness, tr("%1 N/mm").arg(numberText(found.difference * run.reference_N_per_mm, 4)));
  set(kScatter, percent(calibration::scatterOf(found.difference)));
  numbers_->set(kReference, tr("%1 N/mm").arg(numberText(run.reference_N_per_mm, 4)));
  numbers_->set(kTrials, QString::number(run.answers.size()));
  const bool person = session.setup().who == Answering::Person;
  numbers_->set(kWho, person ? tr("a person") : tr("hand, w = %1").arg(percent(session.setup().weber)));
  chart_->present(staircaseSheet(run));
  setNote({});
}

void ResultPage::setTheme(const Theme& theme) {
  chart_->setTheme(theme);
}

void ResultPage::setNote(const QString& note) {
  showMessage(note_, note);
}

}  // namespace underact::gui
