#include "app/gui/fault/fault_watch.h"

#include <QAction>
#include <QDateTime>
#include <QStandardPaths>
#include <QTimer>
#include <QWidget>
#include <ctime>

#include "app/gui/fault/fault_dialog.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/application.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/fault_folder.h"
#include "app/gui/model/servo_rate.h"

namespace underact::gui {
namespace {

constexpr const char* kWindowKind = "window";

record::FaultWords wordsOfException(const std::string& message) {
  return {
      kWindowKind, phrase(QT_TRANSLATE_NOOP("problem", "An internal error occurred in the window: %1."), {message}),
      phrase(QT_TRANSLATE_NOOP("problem",
                               "Save the scene under another name, then press Start. If the error occurs again, quit "
                               "the program and send the fault file to its developers."))};
}

}  // namespace

FaultWatch::FaultWatch(ServoFacts servo, ServoControl control, const ServoRate& rate, Actions& actions, QWidget* window)
    : QObject(window),
      servo_(servo),
      control_(control),
      actions_(actions),
      window_(window),
      recent_(static_cast<std::size_t>(servo.rateHz())) {  // one second
  connect(&rate, &ServoRate::changed, this,
          [this](int, int rate_hz) { recent_ = servo::History(static_cast<std::size_t>(rate_hz)); });
  connect(&actions, &Actions::locked, this, [this] {
    if (dialog_ != nullptr) dialog_->close();
  });
  actions_
      .add({"servo.fault", tr("Show the last &fault"), QKeySequence("Ctrl+Alt+F"),
            tr("Shows what last stopped the servo, and where the fault file is.")},
           [this](const QVariantList&) { return showLast(); })
      ->setEnabled(false);
  Application::onException([this](const std::string& message) { reportException(message); });
}

FaultWatch::~FaultWatch() {
  Application::onException({});
}

void FaultWatch::poll(const servo::Snapshot& snapshot) {
  while (std::optional<servo::FaultReport> report = control_.takeFault()) {
    ShownFault told;
    told.words = record::wordsOf(*report);
    saveAndShow(std::move(*report), std::move(told));
  }
  if (dialog_ != nullptr) dialog_->setStartable(snapshot.mode != servo::Mode::Running);
}

void FaultWatch::reportException(const std::string& message) {
  control_.stop();
  QTimer::singleShot(0, this, [this, message] { reportWindowFault(message); });
}

void FaultWatch::reportWindowFault(const std::string& message) {
  ShownFault told;
  told.words = wordsOfException(message);
  // An error that recurs in every frame is shown once and counted.
  const ShownFault* before = dialog_ != nullptr ? dialog_->last() : nullptr;
  if (before != nullptr && before->words.kind == kWindowKind && before->words.what == told.words.what) {
    dialog_->tellAgain();
    return;
  }
  servo::FaultReport report;
  report.tick = servo_.snapshot().ticks;
  report.unix_time_s = static_cast<std::int64_t>(std::time(nullptr));
  report.last_second = recent_.inOrder();
  report.scene = servo_.scene();
  report.device = servo_.device();
  report.scheduling = servo_.scheduling();
  report.rate_hz = servo_.rateHz();
  report.late = servo_.snapshot().late;
  saveAndShow(std::move(report), std::move(told));
}

void FaultWatch::saveAndShow(servo::FaultReport&& report, ShownFault told) {
  told.when = QDateTime::fromSecsSinceEpoch(report.unix_time_s).toString("hh:mm:ss");
  told.rate_hz = report.rate_hz;
  const Result<std::string> kept = record::saveFault(report, told.words, faultFolder().toStdString());
  if (kept) {
    told.path = QString::fromStdString(kept.value());
  } else {
    const Problem& problem = kept.problems().front();
    told.not_kept = QString("%1 (%2)").arg(sentenceText(problem.sentence), QString::fromStdString(problem.place.file));
  }
  told.last_second = std::move(report.last_second);
  tell(told);
}

void FaultWatch::tell(const ShownFault& told) {
  last_ = std::make_unique<ShownFault>(told);
  actions_.find("servo.fault")->setEnabled(true);
  if (!actions_.isLocked()) dialog().tell(told);  // for visitors the card says it
}

bool FaultWatch::showLast() {
  if (last_ == nullptr) return false;
  if (dialog().last() == nullptr) dialog().tell(*last_);
  dialog().activateWindow();
  return true;
}

FaultDialog& FaultWatch::dialog() {
  if (dialog_ == nullptr) {
    dialog_ = new FaultDialog(window_);
    dialog_->setTheme(theme_);
    connect(dialog_, &FaultDialog::startAsked, this, [this] {
      if (actions_.perform("session.start")) dialog_->close();
    });
    connect(dialog_, &FaultDialog::restartAsked, this, [this] {
      if (actions_.perform("servo.restart")) dialog_->close();
    });
  }
  return *dialog_;
}

void FaultWatch::setTheme(const Theme& theme) {
  theme_ = theme;
  if (dialog_ != nullptr) dialog_->setTheme(theme);
}

}  // namespace underact::gui
