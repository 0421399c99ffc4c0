#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSaveFile>
#include <QVBoxLayout>

#include "app/gui/calibration/calibration_panel.h"
#include "app/gui/calibration/staircase_chart.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/readout.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

enum ResultRow { kJnd, kRange, kStiffness, kReference, kTrials, kScatter, kWho };

QString percent(double share) {
  return QObject::tr("%1 %").arg(numberText(100.0 * share, 1));
}

}  // namespace

ProcedurePage* CalibrationPanel::resultPage() {
  ProcedurePage* const page = addPage();
  numbers_ = new Readout("panel.calibration.result", page);
  none_ = quietLabel(
      "panel.calibration.none",
      tr("No threshold: there were fewer than four reversals, because every difference was felt, or none was."), page);
  saved_ = quietLabel("panel.calibration.saved", {}, page);
  chart_ = staircaseChart(page);
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
  auto* save = page->button("panel.calibration.save", tr("&Save…"),
                            tr("Writes every trial and the result as a CSV file."), tr("Save the trials"));
  auto* again = page->button("panel.calibration.again", tr("A&gain"),
                             tr("Returns to the start. A result that was not saved is lost."), tr("Measure again"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addWidget(save);
  buttons->addWidget(again);
  QVBoxLayout* const column = page->column();
  column->addWidget(none_);
  column->addWidget(numbers_);
  column->addWidget(chart_, 1);
  column->addLayout(buttons);
  column->addWidget(saved_);
  connect(save, &QPushButton::clicked, this, [this] {
    askWhereToSave(this, "dialog.save_calibration", tr("Save the trials"), "jnd.csv",
                   tr("Tables (*.csv);;All files (*)"), [this](const QString& path) { this->save(path); });
  });
  connect(again, &QPushButton::clicked, session_, &CalibrationRun::leave);
  return page;
}

void CalibrationPanel::showResult() {
  const calibration::Measurement& run = session_->run();
  const auto threshold = thresholdOf(run.staircase);
  none_->setVisible(!threshold);
  const auto set = [&](ResultRow row, const QString& text) {
    numbers_->set(row, threshold ? text : QString(QChar(0x2013)));
  };
  const calibration::Threshold found = threshold.value_or(calibration::Threshold{});
  set(kJnd, percent(found.difference));
  set(kRange, tr("%1 to %2").arg(percent(found.low), percent(found.high)));
  set(kStiffness, tr("%1 N/mm").arg(numberText(found.difference * run.reference_N_per_mm, 4)));
  set(kScatter, percent(calibration::scatterOf(found.difference)));
  numbers_->set(kReference, tr("%1 N/mm").arg(numberText(run.reference_N_per_mm, 4)));
  numbers_->set(kTrials, QString::number(run.answers.size()));
  const bool person = session_->setup().who == Answering::Person;
  numbers_->set(kWho, person ? tr("a person") : tr("hand, w = %1").arg(percent(session_->setup().weber)));
  chart_->present(staircaseSheet(run));
  saved_->hide();
}

bool CalibrationPanel::save(const QString& path) {
  if (session_->state() != CalibrationRun::State::Done || path.isEmpty()) return false;
  const CalibrationSetup& setup = session_->setup();
  const QString who = setup.who == Answering::Person
                          ? QStringLiteral("a person")
                          : QStringLiteral("a simulated hand with a Weber fraction of %1").arg(setup.weber);
  const std::string csv = calibration::csvOf(session_->run(), who.toStdString(), setup.seed);
  QSaveFile file(path);  // whole or not at all; a person's threshold is private
  const bool saved = file.open(QIODevice::WriteOnly) && file.setPermissions(QFile::ReadOwner | QFile::WriteOwner) &&
                     file.write(csv.c_str()) >= 0 && file.commit();
  showMessage(saved_, saved ? tr("Saved as %1.").arg(QDir::toNativeSeparators(path))
                            : tr("Not saved: %1. Choose another folder.").arg(file.errorString()));
  return saved;
}

}  // namespace underact::gui
