#include "app/gui/sessions/sessions_panel.h"

#include <QAction>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/feature/parts.h"
#include "app/gui/feature/status_line.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/model/recording.h"
#include "app/gui/model/session_paths.h"
#include "app/gui/model/session_words.h"
#include "app/gui/sessions/buttons_section.h"
#include "app/gui/sessions/job_strip.h"
#include "app/gui/sessions/record_section.h"
#include "app/gui/sessions/session_list.h"
#include "app/gui/sessions/session_tools.h"

namespace underact::gui {
namespace {

constexpr int kGrows_ms = 2000;  // a file that is being recorded has grown by then

}  // namespace

SessionsPanel::SessionsPanel(const Parts& parts, QWidget* parent)
    : Panel(parent), parts_(parts), recording_(&parts.recording) {
  addRecordActions();
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  column->addWidget(record_ = new RecordSection(*recording_, parts_.actions, content));
  column->addWidget(buttons_ = new ButtonsSection(content));
  QLabel* heading = sectionTitle(tr("Recent sessions"), content);
  column->addWidget(heading);
  column->addWidget(list_ = new SessionList(content), 1);
  column->addWidget(job_ = new JobStrip(content));
  auto* tools = new SessionTools(parts_.actions, *list_, *job_, content);
  list_->setTools(tools);
  tools->menu()->addSeparator();
  tools->menu()->addAction(addFolderAction());
  fillWithScroll(this, content);
  QAction* hold = parts_.actions.find("session.hold_to_run");
  if (hold != nullptr) {
    connect(hold, &QAction::toggled, buttons_, &ButtonsSection::setHoldToRun);
    buttons_->setHoldToRun(hold->isChecked());
  }
  // The action of a stylus button is performed when all ticks of this frame have been handled.
  connect(buttons_, &ButtonsSection::pressed, this, &SessionsPanel::press, Qt::QueuedConnection);
  connect(recording_, &Recording::changed, this, &SessionsPanel::presentRecording);
  connect(recording_, &Recording::ended, this, [this](const QString& path) {
    list_->setBusy({});
    list_->chooseLater(path);
    if (!recording_->notice().isEmpty()) bringForward();  // it shows the reason
    parts_.actions.perform(
        "notice.tell",
        tr("Recording saved: %1 (%2)").arg(QFileInfo(path).fileName(), clockText(recording_->status().duration_s)),
        path);
    if (seen_) list_->refresh();
  });
  record_->present();
  presentRecording();
  tellUnfinished();
}

/// Says so once, if the program was killed while it recorded; another window may be recording it, so not at once.
void SessionsPanel::tellUnfinished() {
  QFileInfo left(recording_->unfinished());
  if (recording_->unfinished().isEmpty() || !left.exists()) return;
  QTimer::singleShot(kGrows_ms, this, [this, left, before = left.lastModified()]() mutable {
    left.refresh();
    if (!left.exists() || left.lastModified() != before || recording_->isRunning()) return;
    recording_->forgetUnfinished();
    parts_.actions.perform("notice.tell",
                           tr("The recording %1 was cut off. Press Show to recover it.").arg(left.fileName()),
                           left.absoluteFilePath());
  });
}

void SessionsPanel::addRecordActions() {
  QAction* const record = parts_.actions.add({"session.record",
                                              tr("&Record"),
                                              QKeySequence("Ctrl+Shift+R"),
                                              tr("Starts recording immediately, or stops it."),
                                              "record",
                                              {},
                                              true},
                                             [this](const QVariantList& on) {
                                               if (!on.value(0).toBool()) return recording_->stop();
                                               const bool begun = recording_->start();
                                               if (!begun) bringForward();  // it shows the reason
                                               return begun;
                                             });
  record->setProperty("widestText", tr("Stop recording %1").arg(clockText(0.0)));
  parts_.actions
      .add({"session.mark", tr("Set a &marker"), QKeySequence("M"), tr("Marks this moment in the recording."), {}},
           [this](const QVariantList& label) {
             return recording_->mark(label.isEmpty() ? record_->takeLabel() : label.first().toString());
           })
      ->setEnabled(false);
  parts_.actions.add({"sessions.find", tr("&Find a session"), QKeySequence("Ctrl+Shift+F"),
                      tr("Puts the cursor in the search field.")},
                     [this](const QVariantList&) {
                       bringForward();
                       list_->focusSearch();
                       return true;
                     });
}

QAction* SessionsPanel::addFolderAction() {
  return parts_.actions.add({"sessions.folder", tr("C&hoose folder…"), QKeySequence("Ctrl+Alt+C"),
                             tr("Sets the folder in which sessions are saved and listed.")},
                            [this](const QVariantList& path) {
                              if (!path.isEmpty()) return setFolder(path.first().toString());
                              chooseFolder();
                              return true;
                            });
}

void SessionsPanel::chooseFolder() {
  askForFolder(window(), "dialog.session_folder", tr("Folder for sessions"), recording_->folder(),
               [this](const QString& path) { parts_.actions.perform("sessions.folder", path); });
}

bool SessionsPanel::setFolder(const QString& folder) {
  const QString wrong = prepareSessionFolder(folder);
  job_->say(wrong, true);
  if (!wrong.isEmpty()) return false;
  recording_->setFolder(folder);
  seen_ = true;
  list_->setFolder(folder);
  return true;
}

void SessionsPanel::add(const servo::TickRecord& record) {
  buttons_->add(record);
}

void SessionsPanel::press(ButtonUse use) {
  if (use == ButtonUse::Record) parts_.actions.perform("session.record");
  if (use == ButtonUse::Mark) parts_.actions.perform("session.mark");
}

QString SessionsPanel::busyReason() const {
  return recording_->isRunning() ? tr("A session is being recorded. Stop the recording first.") : QString();
}

void SessionsPanel::finish() {
  recording_->stop(record::EndReason::ProgramEnded);
  job_->cancel();
}

void SessionsPanel::presentRecording() {
  const bool runs = recording_->isRunning();
  if (runs && !was_running_) list_->setBusy(recording_->path());
  was_running_ = runs;
  const record::RecorderStatus& status = recording_->status();
  QAction* record = parts_.actions.find("session.record");
  record->setChecked(runs);  // it may have ended by itself
  record->setText(runs ? tr("Stop &recording") : tr("&Record"));
  record->setIconText(runs ? tr("Stop recording %1").arg(clockText(status.duration_s)) : tr("Record"));
  parts_.actions.find("session.mark")->setEnabled(runs);
  if (!runs)
    parts_.status.setRecording(recording_->notice().isEmpty() ? QString() : tr("not recording"), recording_->notice(),
                               true);
  else if (isDiskLow(status))
    parts_.status.setRecording(tr("recording, disk nearly full"), tr("%1 left.").arg(diskText(status)), true);
  else
    parts_.status.setRecording(status.dropped > 0 ? tr("recording, ticks missing") : tr("recording"),
                               recording_->path(), status.dropped > 0);
}

void SessionsPanel::showEvent(QShowEvent* event) {
  Panel::showEvent(event);
  if (std::exchange(seen_, true)) return;
  list_->setFolder(recording_->folder());
}

}  // namespace underact::gui
