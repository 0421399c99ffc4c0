#include "app/gui/model/window_scene.h"

#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/player.h"
#include "app/gui/model/recording.h"

namespace underact::gui {

WindowScene::WindowScene(const WindowSceneParts& parts, QObject* parent) : QObject(parent), parts_(parts) {
  connect(&parts_.document.undoStack(), &QUndoStack::indexChanged, this, [this] {
    if (is_editing_) return;
    last_by_.clear();  // the person has edited, undone or redone something
    has_own_edits_ = parts_.document.modified();
  });
  connect(&parts_.document, &Document::opened, this, [this] {
    last_by_.clear();
    has_own_edits_ = false;
  });
}

void WindowScene::drain(serve::Service&) {
  if (drain_) drain_();
}

// Programs read English, whatever the window's language is.
std::string WindowScene::refusal() const {
  if (!parts_.document.isOpen()) return phrase(QT_TRANSLATE_NOOP("problem", "No scene is open in the window."));
  if (parts_.player.isOpen())
    return phrase(QT_TRANSLATE_NOOP("problem", "The window plays a recording. Close the replay there first."));
  if (parts_.actions.isLocked())
    return phrase(QT_TRANSLATE_NOOP("problem", "The window is in visitor mode. End it there first."));
  if (parts_.document.isTryingOut())
    return phrase(QT_TRANSLATE_NOOP("problem", "The window measures with a scene of its own. End that there first."));
  return {};
}

Problems WindowScene::load(const scene::Description& scene, const std::string&) {
  if (has_own_edits_)
    return Problems{{phrase(QT_TRANSLATE_NOOP(
        "problem", "The scene in the window has changes that are not saved. Save or undo them there first."))}};
  return parts_.document.open(scene);
}

Problems WindowScene::edit(const scene::Description& edited, std::int64_t over_ticks, const std::string& by) {
  if (std::exchange(last_by_, by) != by)
    gesture_ = parts_.document.newGesture();  // all that it does is one step of undo
  is_editing_ = true;
  Problems problems =
      parts_.document.steer(edited, tr("changes by %1").arg(QString::fromStdString(by)), gesture_, over_ticks);
  is_editing_ = false;
  return problems;
}

std::optional<serve::RecordingNow> WindowScene::recording() {
  if (!parts_.recording.isRunning()) return std::nullopt;
  return serve::RecordingNow{parts_.recording.path().toStdString(), parts_.recording.status().ticks,
                             parts_.recording.path() == clients_path_};
}

Problems WindowScene::startRecording(const std::string& name) {
  if (!parts_.recording.startAs(QString::fromStdString(name)))
    return Problems{{parts_.recording.notice().toStdString()}};
  clients_path_ = parts_.recording.path();
  return {};
}

Result<serve::RecordingNow> WindowScene::endRecording() {
  const QString path = parts_.recording.path();
  parts_.recording.stop();
  if (!parts_.recording.notice().isEmpty()) return Problems{{parts_.recording.notice().toStdString()}};
  return serve::RecordingNow{path.toStdString(), parts_.recording.status().ticks, true};
}

void WindowScene::mark(const std::string& text) {
  parts_.recording.mark(QString::fromStdString(text));
}

}  // namespace underact::gui
