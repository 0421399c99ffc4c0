#include "app/gui/sessions/job_strip.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>
#include <utility>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/sessions/csv_file.h"
#include "app/gui/sessions/plots_run.h"
#include "app/gui/sessions/rerun_check.h"

namespace underact::gui {
namespace {

constexpr int kPollJob_ms = 50;
constexpr int kSteps = 1000;  // of the bar

QString sentenceOf(const CsvFile& done, const QString& out) {
  if (done.cancelled) return QObject::tr("Cancelled: no file was written.");
  if (!done.problems.empty()) return QObject::tr("Not exported. %1").arg(sentencesOf(done.problems));
  const QString whole = QObject::tr("%1 ticks saved in %2").arg(done.rows).arg(QFileInfo(out).fileName());
  return done.missing == 0
             ? whole
             : QObject::tr("%1. %2 damaged ticks of the session were left out.").arg(whole).arg(done.missing);
}

}  // namespace

JobStrip::JobStrip(QWidget* parent)
    : QWidget(parent),
      told_(messageLabel("panel.sessions.told", tr("Result"), "quiet", this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  bar_->setObjectName("panel.sessions.progress");
  bar_->setAccessibleName(tr("Progress"));
  cancel_->setObjectName("panel.sessions.cancel");
  cancel_->setAccessibleName(tr("Cancel the job"));
  cancel_->setToolTip(tr("Stops the job."));
  auto* grid = tight<QGridLayout>(this, 4);
  grid->addWidget(told_, 0, 0, 1, 2);
  grid->addWidget(bar_, 1, 0);
  grid->addWidget(cancel_, 1, 1);
  grid->setColumnStretch(0, 1);
  for (QWidget* widget : {static_cast<QWidget*>(told_), static_cast<QWidget*>(bar_), static_cast<QWidget*>(cancel_)})
    widget->hide();
  poll_timer_.setInterval(kPollJob_ms);
  connect(&poll_timer_, &QTimer::timeout, this, &JobStrip::poll);
  connect(cancel_, &QPushButton::clicked, this, &JobStrip::cancel);
}

JobStrip::~JobStrip() = default;

bool JobStrip::beginCsv(const QString& session, const QString& out) {
  if (!isBusy()) out_ = out;
  return beginJob(tr("Exporting %1").arg(QFileInfo(session).fileName()), [session, out](WorkState& state) -> JobResult {
    const CsvFile done = writeCsvFile(session.toStdString(), out.toStdString(), state);
    return {sentenceOf(done, out), !done.problems.empty(), !done.cancelled && done.problems.empty()};
  });
}

bool JobStrip::beginRerun(const QString& session) {
  if (!isBusy()) out_.clear();
  return beginJob(tr("Running %1 again").arg(QFileInfo(session).fileName()), [session](WorkState& state) {
    const RerunCheck check = checkRerun(session.toStdString(), state);
    JobResult result;
    result.sentence = sentenceOf(check, result.is_alarm);
    return result;
  });
}

bool JobStrip::beginJob(const QString& sentence, std::function<JobResult(WorkState&)> work) {
  if (isBusy()) return false;
  begin(sentence, kSteps);
  job_ = std::make_unique<Background<JobResult>>(std::move(work));
  poll_timer_.start();
  return true;
}

bool JobStrip::beginPlots(const QString& session, const QString& out) {
  if (isBusy()) return false;
  out_ = out;
  begin(tr("Drawing the plots of %1").arg(QFileInfo(session).fileName()), 0);  // indeterminate progress
  plots_ = new PlotsRun(session, out, this);
  connect(plots_, &PlotsRun::finished, this, [this](bool done, const QString& sentence) {
    plots_->deleteLater();
    plots_ = nullptr;
    end({sentence, !done, done});
  });
  plots_->begin();
  return true;
}

void JobStrip::cancel() {
  if (job_ != nullptr) job_->cancel();
  if (plots_ != nullptr) plots_->cancel();
}

void JobStrip::begin(const QString& sentence, int max) {
  say(sentence, false);
  bar_->setRange(0, max);
  bar_->setValue(0);
  bar_->show();
  cancel_->show();
}

void JobStrip::poll() {
  bar_->setValue(static_cast<int>(job_->share() * bar_->maximum()));
  const std::optional<JobResult> done = job_->take();
  if (!done) return;
  poll_timer_.stop();
  job_.reset();
  end(*done);
}

void JobStrip::end(const JobResult& result) {
  bar_->hide();
  cancel_->hide();
  say(result.sentence, result.is_alarm);
  if (result.is_saved && !out_.isEmpty()) emit saved(result.sentence, out_);
  emit ended();
}

void JobStrip::say(const QString& sentence, bool alarm) {
  told_->setText(sentence);
  told_->setProperty("role", alarm ? "alarm" : "quiet");
  told_->style()->polish(told_);
  told_->setVisible(!sentence.isEmpty());
}

}  // namespace underact::gui
