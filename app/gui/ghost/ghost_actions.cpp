#include "app/gui/ghost/ghost_actions.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <functional>

#include "app/gui/files/scene_files.h"
#include "app/gui/ghost/ghost_hand.h"
#include "app/gui/ghost/ghost_words.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "core/base/units.h"
#include "core/scene/mirror.h"

namespace underact::gui {
namespace {

constexpr double kMinWait_mm = 1.0, kMaxWait_mm = 100.0;

void chooseSession(Actions& actions, QWidget* window) {
  askForFile(window, "dialog.follow", tr("Follow a recorded hand"), {},
             tr("Recorded sessions (*.h5 *.hdf5);;All files (*)"),
             [&actions](const QString& path) { actions.perform("ghost.open", path); });
}

/// name: of a command with one argument that changes the options. put: false for an invalid argument.
void addOption(Actions& actions, GhostHand& ghost, const char* name,
               std::function<bool(ghost::Options& options, const QVariant& to)> put) {
  actions.addCommand(name, [&ghost, put = std::move(put)](const QVariantList& to) {
    if (!ghost.isOpen() || to.size() != 1) return false;
    ghost::Options options = ghost.options();
    if (!put(options, to.first())) return false;
    ghost.setOptions(options);
    return true;
  });
}

bool putWithin(double& number, const QVariant& to, double min, double max, double unit) {
  bool is_number = false;
  const double asked = to.toDouble(&is_number);
  if (!is_number || !(asked >= min && asked <= max)) return false;
  number = unit * asked;
  return true;
}

void addOptions(Actions& actions, GhostHand& ghost) {
  const auto flag = [](bool ghost::Options::*which) {
    return [which](ghost::Options& options, const QVariant& to) {
      options.*which = to.toBool();
      return true;
    };
  };
  addOption(actions, ghost, "ghost.loop", flag(&ghost::Options::loops));
  addOption(actions, ghost, "ghost.wait", flag(&ghost::Options::waits));
  addOption(actions, ghost, "ghost.near", flag(&ghost::Options::begins_near));
  addOption(actions, ghost, "ghost.speed", [](ghost::Options& options, const QVariant& to) {
    return putWithin(options.speed, to, ghost::kSlowest, ghost::kFastest, 1.0);
  });
  addOption(actions, ghost, "ghost.wait_beyond", [](ghost::Options& options, const QVariant& to_mm) {
    return putWithin(options.waits_beyond_m, to_mm, kMinWait_mm, kMaxWait_mm, kMetrePerMillimetre);
  });
}

}  // namespace

void addGhostActions(Actions& actions, GhostHand& ghost, const Document& document, SceneFiles& files, QWidget* window) {
  actions.add({"ghost.open",
               tr("Follow a &recorded hand…"),
               {},
               tr("Shows a recorded stylus as a ghost beside yours, and your distance to it.")},
              [&actions, &ghost, window](const QVariantList& path) {
                if (!path.isEmpty()) return ghost.open(path.first().toString());
                chooseSession(actions, window);
                return true;
              });
  actions.add({"ghost.play", tr("&Play or pause"), QKeySequence("G"), tr("Plays or pauses the ghost."), "play"},
              [&ghost](const QVariantList& on) {
                ghost.play(on.value(0, !ghost.isPlaying()).toBool());
                return true;
              });
  actions.add({"ghost.restart", tr("From the &beginning"), QKeySequence("Shift+G"),
               tr("Starts the ghost from the beginning and resets the count."), "reset"},
              [&ghost](const QVariantList&) {
                ghost.restart();
                return true;
              });
  actions.add({"ghost.close", tr("&Close"), QKeySequence("Ctrl+G"), tr("Removes the ghost.")},
              [&ghost](const QVariantList&) {
                ghost.close();
                return true;
              });
  addOptions(actions, ghost);
  actions.addCommand("ghost.mirror", [&ghost](const QVariantList& on) {
    if (!ghost.isOpen() || on.size() != 1) return false;
    ghost.setMirrored(on.first().toBool());
    return true;
  });
  actions.addCommand("ghost.scene", [&ghost, &document, &files](const QVariantList&) {
    if (!ghost.isOpen() || !ghost.ghost().scene) return false;
    scene::Description scene = *ghost.scene();
    return files.openLoaded(document.opensMirrored() ? scene::mirrored(scene) : scene);  // mirrored back when it opens
  });
  actions.addCommand("ghost.copy", [&ghost](const QVariantList&) {
    if (!ghost.isOpen() || !ghost.state().last_round) return false;
    QGuiApplication::clipboard()->setText(resultText(*ghost.state().last_round));
    return true;
  });
  const auto enable = [&actions, &ghost] {
    for (const char* name : {"play", "restart", "close"})
      actions.find(QString("ghost.") + name)->setEnabled(ghost.isOpen());
  };
  enable();
  QObject::connect(&ghost, &GhostHand::opened, &actions, enable);
  QObject::connect(&ghost, &GhostHand::closed, &actions, enable);
}

}  // namespace underact::gui
