#include "app/gui/replay/replay_actions.h"

#include <QAction>
#include <QFileInfo>
#include <functional>

#include "app/gui/files/scene_files.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/player.h"
#include "app/gui/model/recorded_files.h"

namespace underact::gui {
namespace {

void chooseReplay(Actions& actions, QWidget* window) {
  askForFile(window, "dialog.session", tr("Replay a session"), {}, tr("Recorded sessions (*.h5 *.hdf5);;All files (*)"),
             [&actions](const QString& path) { actions.perform("replay.open", path); });
}

void addPlaying(Actions& actions, Player& player) {
  struct Row {
    const char *name, *text, *shortcut, *tip, *icon;
    std::function<void(const QVariantList&)> run;
  };
  const Row rows[] = {
      {"replay.play", QT_TR_NOOP("&Play or pause"), "P", QT_TR_NOOP("Plays the recording or pauses it."), "play",
       [&player](const QVariantList& on) {
         on.value(0, !player.isPlaying()).toBool() ? player.play() : player.pause();
       }},
      {"replay.back", QT_TR_NOOP("One tick &back"), ",", QT_TR_NOOP("Pauses and shows the previous tick."), "back",
       [&player](const QVariantList&) {
         player.pause();
         player.step(-1);
       }},
      {"replay.forward", QT_TR_NOOP("One tick &forward"), ".", QT_TR_NOOP("Pauses and shows the next tick."), "forward",
       [&player](const QVariantList&) {
         player.pause();
         player.step(1);
       }},
      {"replay.loop_in", QT_TR_NOOP("Start loop &here"), "I", QT_TR_NOOP("Sets the start of the loop to this tick."),
       "",
       [&player](const QVariantList&) {
         player.setLoopIn(player.row());
         player.setLoop(true);
       }},
      {"replay.loop_out", QT_TR_NOOP("&End loop here"), "O", QT_TR_NOOP("Sets the end of the loop to this tick."), "",
       [&player](const QVariantList&) {
         player.setLoopOut(player.row());
         player.setLoop(true);
       }}};
  for (const Row& row : rows) {
    actions.add({row.name, tr(row.text), QKeySequence(row.shortcut), tr(row.tip), row.icon},
                [run = row.run](const QVariantList& arguments) {
                  run(arguments);
                  return true;
                });
  }
  actions.add({"replay.loop",
               tr("&Loop"),
               QKeySequence("L"),
               tr("Repeats the part between the start and the end of the loop."),
               {},
               {},
               true},
              [&player](const QVariantList& on) {
                player.setLoop(on.value(0).toBool());
                return true;
              });
}

void chooseFolder(Actions& actions, QWidget* window) {
  askForFolder(window, "dialog.replay_files", tr("Folder with the meshes and curves of sessions"), {},
               [&actions](const QString& path) { actions.perform("replay.files", path); });
}

/// Saves the folder, and opens again the session that needed it.
bool setFolder(Player& player, const QString& folder) {
  if (!QFileInfo(folder).isDir()) return false;
  rememberRecordedFiles(QFileInfo(folder).absoluteFilePath());
  return player.path().isEmpty() || player.open(player.path());
}

void addCommands(Actions& actions, Player& player) {
  actions.addCommand("replay.seek", [&player](const QVariantList& seconds) {
    bool is_number = false;
    const double time_s = seconds.value(0).toDouble(&is_number);
    if (!is_number || !player.isOpen()) return false;
    player.seek(qRound64(time_s * player.recorded().rate_hz));
    return true;
  });
  actions.addCommand("replay.speed", [&player](const QVariantList& times) {
    bool is_number = false;
    const double speed = times.value(0).toDouble(&is_number);
    if (!is_number || !player.isOpen()) return false;
    player.setSpeed(speed);
    return true;
  });
}

}  // namespace

void addReplayActions(Actions& actions, Player& player, SceneFiles& files, QWidget* window) {
  actions.add({"replay.open", tr("&Open session…"), QKeySequence("Ctrl+Shift+O"),
               tr("Opens a recorded session and replays it."), "open"},
              [&actions, &player, &files, window](const QVariantList& path) {
                if (path.isEmpty()) {
                  chooseReplay(actions, window);
                  return true;
                }
                if (player.isOpen() && !files.settleEdits()) return false;  // edits made to the previous one
                actions.perform("calibration.cancel");
                closeProblems();
                return player.open(path.first().toString());
              });
  actions.add({"replay.files",
               tr("Folder w&ith meshes and curves…"),
               {},
               tr("Sets a folder in which replays look for meshes and curves: sessions store only their file names.")},
              [&actions, &player, &files, window](const QVariantList& folder) {
                if (folder.isEmpty()) {
                  chooseFolder(actions, window);
                  return true;
                }
                if (player.isOpen() && !files.settleEdits()) return false;
                return setFolder(player, folder.first().toString());
              });
  addPlaying(actions, player);
  actions.add({"replay.what_if",
               tr("&What if"),
               {},
               tr("Replays the recorded hand with the scene and gains of the window instead of the recorded ones."),
               {},
               {},
               true},
              [&player](const QVariantList& on) {
                player.setWhatIf(on.value(0).toBool());
                return true;
              });
  actions.add(
      {"replay.close", tr("&Close session"), {}, tr("Ends the replay and restores the previous arm and scene.")},
      [&player, &files](const QVariantList&) {
        if (!files.settleEdits()) return false;
        player.close();
        return true;
      });
  addCommands(actions, player);
  const auto enable = [&actions, &player] {
    for (const char* name : {"play", "back", "forward", "loop", "loop_in", "loop_out", "what_if", "close"})
      actions.find(QString("replay.") + name)->setEnabled(player.isOpen());
    actions.find("replay.loop")->setChecked(player.isOpen() && player.loops());
    actions.find("replay.what_if")->setChecked(player.isOpen() && player.whatIf());
  };
  enable();
  QObject::connect(&player, &Player::opened, &actions, [&player, &actions] {
    actions.perform("view.fit");
    player.play();
  });
  for (const auto signal : {&Player::opened, &Player::closed, &Player::changed})
    QObject::connect(&player, signal, &actions, enable);
  QObject::connect(&player, &Player::whatIfChanged, &actions, enable);
}

}  // namespace underact::gui
