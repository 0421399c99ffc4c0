#include "app/gui/sessions/session_tools.h"

#include <QAction>
#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <QUrl>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/sessions/delete_question.h"
#include "app/gui/sessions/job_strip.h"
#include "app/gui/sessions/metadata_dialog.h"
#include "app/gui/sessions/session_list.h"
#include "core/record/recorder.h"

namespace underact::gui {

constexpr int kMargins = 24;  // of a button, beside its text

SessionTools::SessionTools(Actions& actions, SessionList& list, JobStrip& job, QWidget* parent)
    : QWidget(parent), actions_(actions), list_(list), job_(job) {
  addActions();
  buildMenu();
  buildButtons();
  connect(&list, &SessionList::chosenChanged, this, &SessionTools::presentChosen);
  connect(&list, &SessionList::activated, this, [this] {
    if (list_.chosen() != nullptr) actions_.perform("replay.open", list_.chosen()->path);
  });
  connect(&list, &SessionList::menuAsked, this, [this](const QPoint& where) { menu_->popup(where); });
  connect(&list, &SessionList::deleteAsked, this, [this] { actions_.perform("sessions.delete"); });
  connect(&job, &JobStrip::ended, this, &SessionTools::presentChosen);
  connect(&job, &JobStrip::saved, this,
          [this](const QString& sentence, const QString& path) { actions_.perform("notice.tell", sentence, path); });
  presentChosen();
}

void SessionTools::addActions() {
  const auto add = [this](const char* name, const QString& text, const QString& tip,
                          std::function<bool(const QVariantList&)> run) {
    actions_.add({name, text, {}, tip}, std::move(run));
  };
  actions_.addCommand("sessions.choose",
                      [this](const QVariantList& path) { return list_.choose(path.value(0).toString()); });
  add("sessions.export", tr("Export as &CSV…"), tr("Saves the ticks of the selected session as a table."),
      [this](const QVariantList& path) {
        if (!path.isEmpty()) return write(path.first().toString(), &JobStrip::beginCsv);
        chooseFile(tr("Export the session as CSV"), "csv", "sessions.export");
        return true;
      });
  add("sessions.plots", tr("&Plots as PDF…"), tr("Saves all plots of the selected session, one file each."),
      [this](const QVariantList& path) {
        if (!path.isEmpty()) return write(path.first().toString(), &JobStrip::beginPlots);
        chooseFile(tr("Save the plots"), "pdf", "sessions.plots");
        return true;
      });
  add("sessions.rerun", tr("Run a&gain"),
      tr("Repeats the run of the selected session from its file, and compares every tick to the last bit."),
      [this](const QVariantList&) {
        const bool begun = job_.beginRerun(list_.chosen()->path);
        presentChosen();
        return begun;
      });
  add("sessions.follow", tr("Fo&llow"),
      tr("Shows the recorded stylus of the selected session as a ghost for a hand to follow."),
      [this](const QVariantList&) { return actions_.perform("ghost.open", list_.chosen()->path); });
  add("sessions.show", tr("&Show in folder"), tr("Opens the folder of the selected session."),
      [this](const QVariantList&) {
        return QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(list_.chosen()->path).absolutePath()));
      });
  add("sessions.edit", tr("&Edit metadata…"),
      tr("Edits the name, notes, tags, subject and consent of the selected session."),
      [this](const QVariantList&) { return edit(); });
  add("sessions.recover", tr("Rec&over"),
      tr("Repairs a session that was not closed, so that every program can open it."),
      [this](const QVariantList&) { return recover(); });
  add("sessions.delete", tr("&Delete…"), tr("Moves the selected session to the bin, or deletes it permanently."),
      [this](const QVariantList& asked) { return moveToBin(asked.value(0).toBool()); });
  actions_.addCommand("sessions.remove", [this](const QVariantList& asked) {
    return list_.chosen() != nullptr && remove(asked.value(0).toBool());
  });
}

void SessionTools::buildMenu() {
  menu_ = new QMenu(tr("More"), this);
  menu_->setObjectName("panel.sessions.menu");
  for (const char* name : {"sessions.follow", "sessions.rerun", "sessions.export", "sessions.plots", "sessions.show",
                           "sessions.edit", "sessions.recover", "sessions.delete"})
    menu_->addAction(actions_.find(name));
}

void SessionTools::buildButtons() {
  auto* row = tight<QHBoxLayout>(this, 4);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    QPushButton* made = pushButton(QString("panel.sessions.") + name, text, tip, this);
    made->setMinimumWidth(made->fontMetrics().horizontalAdvance(text) + kMargins);  // up to four fit
    row->addWidget(made);
    return made;
  };
  replay_ = button("replay", tr("Replay"), tr("Replays the selected session."));
  recover_ = button("recover", tr("Recover"), actions_.find("sessions.recover")->toolTip());
  export_ = button("export", tr("CSV…"), actions_.find("sessions.export")->toolTip());
  export_->setAccessibleName(tr("Export as CSV"));
  row->addStretch(1);
  QPushButton* more = button("more", tr("More"), tr("More commands for the selected session and the folder."));
  more->setMinimumWidth(more->minimumWidth() + kMargins);  // for the arrow
  more->setMenu(menu_);
  connect(replay_, &QPushButton::clicked, this, [this] { actions_.perform("replay.open", list_.chosen()->path); });
  connect(recover_, &QPushButton::clicked, this, [this] { actions_.perform("sessions.recover"); });
  connect(export_, &QPushButton::clicked, this, [this] { actions_.perform("sessions.export"); });
}

void SessionTools::presentChosen() {
  const SessionEntry* chosen = list_.chosen();
  const bool any = chosen != nullptr, readable = any && chosen->isReadable(), closed = any && chosen->isClosed();
  const auto allow = [this](const char* name, bool allowed) { actions_.find(name)->setEnabled(allowed); };
  allow("sessions.export", readable && !job_.isBusy());
  allow("sessions.plots", readable && !job_.isBusy());
  allow("sessions.rerun", readable && !job_.isBusy());
  allow("sessions.follow", readable);
  allow("sessions.show", any);
  allow("sessions.edit", closed);
  allow("sessions.recover", readable && !closed);
  allow("sessions.delete", any);
  // A button is shown only together with its action.
  replay_->setVisible(actions_.find("replay.open") != nullptr);
  replay_->setEnabled(readable);
  recover_->setVisible(readable && !closed);
  export_->setEnabled(readable && !job_.isBusy());
}

bool SessionTools::write(const QString& path, Begin begin) {
  if (!(job_.*begin)(list_.chosen()->path, path)) return false;
  presentChosen();
  return true;
}

void SessionTools::chooseFile(const QString& title, const QString& suffix, const QString& action) {
  const QFileInfo session(list_.chosen()->path);
  QString stem = session.completeBaseName();
  if (stem.endsWith(".underact")) stem.chop(9);
  askWhereToSave(window(), "dialog.save_session", title, session.absoluteDir().filePath(stem + "." + suffix),
                 QString("*.%1").arg(suffix), [this, action](const QString& path) { actions_.perform(action, path); });
}

bool SessionTools::edit() {
  const SessionEntry& chosen = *list_.chosen();
  auto* dialog = new MetadataDialog(chosen.path, chosen.info.header.words, window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &MetadataDialog::written, &list_, &SessionList::refresh);
  dialog->open();
  return true;
}

bool SessionTools::recover() {
  const QString path = list_.chosen()->path;
  const Result<std::int64_t> ticks = record::recover(path.toStdString());
  job_.say(ticks ? tr("The session was recovered up to its last tenth of a second: %1 ticks.").arg(ticks.value())
                 : sentencesOf(ticks.problems()),
           !ticks);
  list_.refresh();
  return static_cast<bool>(ticks);
}

bool SessionTools::moveToBin(bool asked) {
  const QString path = list_.chosen()->path;
  if (!asked) {
    DeleteQuestion* question = askToDelete(titleOf(*list_.chosen()), path, window());
    connect(question, &DeleteQuestion::binWanted, this, [this, path] {
      if (list_.choose(path)) actions_.perform("sessions.delete", true);
    });
    connect(question, &DeleteQuestion::removalWanted, this, [this, path] {
      if (list_.choose(path)) actions_.perform("sessions.remove");
    });
    return true;
  }
  return tellGone(
      QFile::moveToTrash(path),
      tr("%1 was moved to the bin and stays there until the bin is emptied.").arg(QFileInfo(path).fileName()),
      tr("The session cannot be moved to the bin: its folder has no bin or is write-protected. Delete the session "
         "permanently, or choose Show in folder and delete it there."));
}

bool SessionTools::remove(bool asked) {
  const QString path = list_.chosen()->path;
  if (!asked) {
    DeleteQuestion* question = askToRemove(titleOf(*list_.chosen()), path, window());
    connect(question, &DeleteQuestion::removalWanted, this, [this, path] {
      if (list_.choose(path)) actions_.perform("sessions.remove", true);
    });
    return true;
  }
  return tellGone(QFile::remove(path), tr("%1 was deleted permanently.").arg(QFileInfo(path).fileName()),
                  tr("The session cannot be removed: its folder is write-protected. Choose Show in folder, and ask the "
                     "owner of the folder."));
}

bool SessionTools::tellGone(bool is_gone, const QString& gone, const QString& refusal) {
  job_.say(is_gone ? gone : refusal, !is_gone);
  list_.refresh();
  return is_gone;
}

}  // namespace underact::gui
