// What the panel does with a session that was chosen.
#include <QAction>
#include <QDesktopServices>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <QUrl>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/recording.h"
#include "app/gui/model/session_place.h"
#include "app/gui/sessions/delete_question.h"
#include "app/gui/sessions/job_strip.h"
#include "app/gui/sessions/session_list.h"
#include "app/gui/sessions/sessions_panel.h"
#include "app/gui/sessions/words_dialog.h"

namespace underact::gui {

constexpr int kMargins = 24;  // of a button, beside its words

void SessionsPanel::addListActions() {
  const auto add = [this](const char* name, const QString& text, const char* keys, const QString& tip,
                          std::function<bool(const QVariantList&)> run) {
    parts_.actions.add({name, text, QKeySequence(keys), tip}, std::move(run));
  };
  add("sessions.find", tr("&Find a session"), "Ctrl+Shift+F", tr("Puts the cursor into the search field."),
      [this](const QVariantList&) {
        bringForward();
        list_->focusSearch();
        return true;
      });
  parts_.actions.addCommand("sessions.choose",
                            [this](const QVariantList& path) { return list_->choose(path.value(0).toString()); });
  add("sessions.export", tr("Export as &CSV…"), "Ctrl+Shift+E", tr("Writes the chosen session's ticks as a table."),
      [this](const QVariantList& path) {
        if (!path.isEmpty()) return exportCsvTo(path.first().toString());
        chooseFile(tr("Export the session as CSV"), "csv", "sessions.export");
        return true;
      });
  add("sessions.plots", tr("&Plots as PDF…"), "Ctrl+Shift+P", tr("Draws all plots of the chosen session, a file each."),
      [this](const QVariantList& path) {
        if (!path.isEmpty()) return plotTo(path.first().toString());
        chooseFile(tr("Save the plots"), "pdf", "sessions.plots");
        return true;
      });
  add("sessions.follow", tr("Fo&llow"), "Ctrl+Shift+G",
      tr("Lets the chosen session's stylus go its way beside yours, as a ghost to follow."),
      [this](const QVariantList&) { return parts_.actions.perform("ghost.open", list_->chosen()->path); });
  add("sessions.show", tr("&Show in folder"), "Ctrl+Alt+O", tr("Opens the folder that holds the chosen session."),
      [this](const QVariantList&) {
        return QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(list_->chosen()->path).absolutePath()));
      });
  add("sessions.edit", tr("&Edit words…"), "Ctrl+Alt+E",
      tr("Changes the chosen session's name, notes, tags, subject and consent."),
      [this](const QVariantList&) { return editChosen(); });
  add("sessions.recover", tr("Rec&over"), "Ctrl+Alt+U",
      tr("Makes a session whole that the program could not close, so that every program opens it."),
      [this](const QVariantList&) { return recoverChosen(); });
  add("sessions.delete", tr("&Delete…"), "Ctrl+Shift+Del",
      tr("Moves the chosen session to the bin, or removes it for good."),
      [this](const QVariantList& asked) { return deleteChosen(asked.value(0).toBool()); });
  parts_.actions.addCommand("sessions.remove", [this](const QVariantList& asked) {
    return list_->chosen() != nullptr && removeChosen(asked.value(0).toBool());
  });
  add("sessions.folder", tr("C&hoose folder…"), "Ctrl+Alt+C", tr("Where recordings go, and which are listed."),
      [this](const QVariantList& path) {
        if (!path.isEmpty()) return setFolder(path.first().toString());
        chooseFolder();
        return true;
      });
}

QWidget* SessionsPanel::buildButtons() {
  menu_ = new QMenu(tr("More"), this);
  menu_->setObjectName("panel.sessions.menu");
  for (const char* name : {"sessions.follow", "sessions.export", "sessions.plots", "sessions.show", "sessions.edit",
                           "sessions.recover", "sessions.delete"})
    menu_->addAction(parts_.actions.find(name));
  menu_->addSeparator();
  menu_->addAction(parts_.actions.find("sessions.folder"));
  auto* strip = new QWidget(this);
  auto* row = new QHBoxLayout(strip);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    QPushButton* made = pushButton(QString("panel.sessions.") + name, text, tip, strip);
    made->setMinimumWidth(made->fontMetrics().horizontalAdvance(text) + kMargins);  // all four may stand there
    row->addWidget(made);
    return made;
  };
  replay_ = button("replay", tr("Replay"), tr("Shows the chosen session again."));
  recover_ = button("recover", tr("Recover"), parts_.actions.find("sessions.recover")->toolTip());
  export_ = button("export", tr("CSV…"), parts_.actions.find("sessions.export")->toolTip());
  export_->setAccessibleName(tr("Export as CSV"));
  row->addStretch(1);
  more_ = button("more", tr("More"), tr("What else can be done with the chosen session, and the folder."));
  more_->setMinimumWidth(more_->minimumWidth() + kMargins);  // and the arrow
  more_->setMenu(menu_);
  connect(replay_, &QPushButton::clicked, this,
          [this] { parts_.actions.perform("replay.open", list_->chosen()->path); });
  connect(recover_, &QPushButton::clicked, this, [this] { parts_.actions.perform("sessions.recover"); });
  connect(export_, &QPushButton::clicked, this, [this] { parts_.actions.perform("sessions.export"); });
  return strip;
}

void SessionsPanel::presentChosen() {
  const SessionEntry* chosen = list_->chosen();
  const bool any = chosen != nullptr, readable = any && chosen->isReadable(), closed = any && chosen->isClosed();
  const auto allow = [this](const char* name, bool allowed) { parts_.actions.find(name)->setEnabled(allowed); };
  allow("sessions.export", readable && !job_->isBusy());
  allow("sessions.plots", readable && !job_->isBusy());
  allow("sessions.follow", readable);
  allow("sessions.show", any);
  allow("sessions.edit", closed);
  allow("sessions.recover", readable && !closed);
  allow("sessions.delete", any);
  // A button comes together with what it does.
  replay_->setVisible(parts_.actions.find("replay.open") != nullptr);
  replay_->setEnabled(readable);
  recover_->setVisible(readable && !closed);
  export_->setEnabled(readable && !job_->isBusy());
}

bool SessionsPanel::exportCsvTo(const QString& path) {
  if (!job_->beginCsv(list_->chosen()->path, path)) return false;
  presentChosen();
  return true;
}

bool SessionsPanel::plotTo(const QString& path) {
  if (!job_->beginPlots(list_->chosen()->path, path)) return false;
  presentChosen();
  return true;
}

bool SessionsPanel::recoverChosen() {
  const QString path = list_->chosen()->path;
  const Result<std::int64_t> ticks = record::recover(path.toStdString());
  job_->say(ticks ? tr("The session is whole up to its last tenth of a second: %1 ticks.").arg(ticks.value())
                  : sentencesOf(ticks.problems()),
            !ticks);
  list_->refresh();
  return static_cast<bool>(ticks);
}

bool SessionsPanel::editChosen() {
  const SessionEntry& chosen = *list_->chosen();
  auto* dialog = new WordsDialog(chosen.path, chosen.info.header.words, window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &WordsDialog::written, list_, &SessionList::refresh);
  dialog->open();
  return true;
}

bool SessionsPanel::deleteChosen(bool asked) {
  const SessionEntry& chosen = *list_->chosen();
  const QString path = chosen.path;
  if (!asked) {
    DeleteQuestion* question = askToDelete(titleOf(chosen), path, window());
    connect(question, &DeleteQuestion::binWanted, this, [this, path] {
      if (list_->choose(path)) parts_.actions.perform("sessions.delete", true);
    });
    connect(question, &DeleteQuestion::removalWanted, this, [this, path] {
      if (list_->choose(path)) parts_.actions.perform("sessions.remove");
    });
    return true;
  }
  const bool moved = QFile::moveToTrash(path);
  job_->say(moved ? tr("%1 is in the bin, which keeps it until it is emptied.").arg(QFileInfo(path).fileName())
                  : tr("The session cannot be moved to the bin: this folder has none, or may not be changed. Remove it "
                       "for good, or show it in its folder and delete it there."),
            !moved);
  list_->refresh();
  return moved;
}

bool SessionsPanel::removeChosen(bool asked) {
  const SessionEntry& chosen = *list_->chosen();
  const QString path = chosen.path;
  if (!asked) {
    DeleteQuestion* question = askToRemove(titleOf(chosen), path, window());
    connect(question, &DeleteQuestion::removalWanted, this, [this, path] {
      if (list_->choose(path)) parts_.actions.perform("sessions.remove", true);
    });
    return true;
  }
  const bool removed = QFile::remove(path);
  job_->say(removed ? tr("%1 was removed for good.").arg(QFileInfo(path).fileName())
                    : tr("The session cannot be removed: its folder may not be changed. Show in folder, and ask whose "
                         "folder it is."),
            !removed);
  list_->refresh();
  return removed;
}

void SessionsPanel::chooseFile(const QString& title, const QString& suffix, const QString& action) {
  const QFileInfo session(list_->chosen()->path);
  auto* dialog = new QFileDialog(window(), title, session.absolutePath(), QString("*.%1").arg(suffix));
  dialog->setObjectName("dialog.save_session");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(suffix);
  QString stem = session.completeBaseName();
  if (stem.endsWith(".underact")) stem.chop(9);
  dialog->selectFile(stem + "." + suffix);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, action](const QString& path) { parts_.actions.perform(action, path); });
  dialog->open();
}

void SessionsPanel::chooseFolder() {
  auto* dialog = new QFileDialog(window(), tr("Folder of the recordings"), recording_->folder());
  dialog->setObjectName("dialog.session_folder");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& path) { parts_.actions.perform("sessions.folder", path); });
  dialog->open();
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

}  // namespace underact::gui
