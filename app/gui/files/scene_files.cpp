#include "app/gui/files/scene_files.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <memory>
#include <utility>

#include "app/gui/files/load_strip.h"
#include "app/gui/files/opening.h"
#include "app/gui/files/tuned_scenes.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/shipped.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/model/scene_loading.h"
#include "app/gui/view/drawn_mesh.h"
#include "core/scene/edit.h"
#include "core/scene/load_meshes.h"
#include "core/scene/mirror.h"
#include "core/scene/read.h"

namespace underact::gui {
namespace {

QString filterText() {
  return QObject::tr("Scenes (*.json);;All files (*)");
}

/// Whether it came with the program: nobody's own files go there.
bool isShipped(const QString& path) {
  const QString folder = QFileInfo(path).absolutePath();
  return folder == sceneFolder() || folder.startsWith(shippedFolder(system::Resource::Lessons));
}

/// The folder of the user's own files.
QString ownFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

/// The suggested path for a tuned scene: its own, unless it came with the program or has none. The double ending tells
/// the desktop that it is a scene; any JSON file can be opened.
QString placeToSave(const Document& document) {
  if (!document.path().isEmpty() && !isShipped(document.path())) return QFileInfo(document.path()).absoluteFilePath();
  const QString unnamed = document.showsRecorded() ? QObject::tr("recorded") : QObject::tr("new");
  const QString stem = document.path().isEmpty() ? unnamed : QFileInfo(document.path()).baseName();
  return QDir(ownFolder()).filePath(stem + "-tuned.underact.json");
}

}  // namespace

SceneFiles::SceneFiles(Document& document, RecentFiles& recent, LoadStrip& loads, QWidget* window)
    : QObject(window),
      document_(document),
      recent_(recent),
      loads_(loads),
      window_(window),
      problems_(new ProblemsDialog(window)) {
  connect(problems_, &ProblemsDialog::openAnother, this, &SceneFiles::chooseAndOpen);
}

bool SceneFiles::open(const QString& path) {
  if (!settleEdits()) return false;
  loads_.cancel();  // only the last request counts
  const QString file = QFileInfo(path).absoluteFilePath();
  Result<scene::Description> read = scene::readSceneFile(file.toStdString());
  if (!read) {
    problems_->show(path, read.problems());
    return false;
  }
  Read opened{std::move(read).value()};
  if (isShipped(file) && !document_.keepsAsWritten()) opened.tuned = tuned_scenes::of(opened.scene);
  if (!scene::lacksMeshes(opened.scene)) return put(std::move(opened));
  loadAndPut(std::move(opened));
  return true;
}

void SceneFiles::loadAndPut(Read read) {
  struct Loaded {
    Read read;
    Problems problems;
    std::vector<target::CurvePath> curves;
  };
  const auto loaded = std::make_shared<Loaded>();
  loaded->read = std::move(read);
  const QString path = QString::fromStdString(loaded->read.scene.file);
  loads_.begin(
      tr("Loading the files of %1").arg(QFileInfo(path).fileName()),
      [loaded, is_mirrored = document_.opensMirrored()](const TaskMonitor& monitor) {
        Read& now = loaded->read;
        loaded->problems = scene::loadMeshes(now.scene, monitor);
        if (now.tuned && !scene::loadMeshes(*now.tuned, monitor).empty()) now.tuned.reset();
        if (!loaded->problems.empty()) return;
        const scene::Description& seen = now.tuned ? *now.tuned : now.scene;
        loaded->curves = madeCurves(is_mirrored ? scene::mirrored(seen) : seen, monitor);
        makeDrawnMeshes(seen, monitor);
      },
      [this, loaded, path, before = document_.scene()] {
        if (!loaded->problems.empty()) {
          problems_->show(path, loaded->problems);
        } else if (scene::isSame(document_.scene(), before) || settleEdits()) {  // edits made during loading
          static_cast<void>(put(std::move(loaded->read)));
        }
      });
}

bool SceneFiles::put(Read read) {
  const QString path = QString::fromStdString(read.scene.file);
  Problems problems = document_.open(read.scene, read.tuned);
  const bool is_tuned = read.tuned && problems.empty();
  if (read.tuned && !is_tuned) problems = document_.open(std::move(read.scene));
  if (!problems.empty()) {
    problems_->show(path, problems);
    return false;
  }
  closeProblems();
  if (!path.isEmpty() && !isShipped(path)) recent_.add(path);
  tunable_ = isShipped(path) && !document_.keepsAsWritten() ? path : QString();
  if (is_tuned) emit tunedAgain();
  return true;
}

bool SceneFiles::openLoaded(scene::Description scene) {
  if (!settleEdits() || !put({std::move(scene)})) return false;
  tunable_.clear();  // it may not be as in its file
  return true;
}

void SceneFiles::chooseAndOpen() {
  askForFile(window_, "dialog.open", tr("Open a file"),
             QFileInfo(document_.path().isEmpty() ? sceneFolder() + "/." : document_.path()).absolutePath(),
             filterOfAll(), [this](const QString& path) { emit chosen(path); });
}

bool SceneFiles::saveAs(const QString& path) {
  const Problems problems = document_.saveAs(path);
  if (problems.empty()) {
    recent_.add(document_.path());
    emit saved(document_.path());
    return true;
  }
  QMessageBox box(QMessageBox::Warning, tr("Scene not saved"), sentencesOf(problems), QMessageBox::Ok, window_);
  box.setObjectName("dialog.not_saved");
  box.exec();
  return false;
}

void SceneFiles::chooseAndSave() {
  askWhereToSave(window_, "dialog.save", tr("Save the tuned scene"), placeToSave(document_), filterText(),
                 [this](const QString& path) { saveAs(path); });
}

/// Whether nobody needs to be asked: the scene is one that came with the program.
bool SceneFiles::keepTuning() const {
  if (tunable_.isEmpty() || document_.path() != tunable_) return false;
  const scene::Description original = document_.originalAsWritten(), now = document_.asWritten();
  if (document_.modified() || scene::isSame(original, now)) tuned_scenes::keep(original, now);
  return true;
}

bool SceneFiles::settleEdits() {
  if (keepTuning()) return true;
  if (!document_.modified()) return true;
  const QString title = QString::fromStdString(document_.scene().title);
  const bool is_new = document_.path().isEmpty() && !document_.showsRecorded();
  QMessageBox box(QMessageBox::Question, is_new ? tr("New scene") : tr("Unsaved changes"),
                  is_new ? tr("The scene “%1” has not been saved.").arg(title)
                         : tr("The scene “%1” has unsaved changes.").arg(title),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  box.setObjectName("dialog.unsaved");
  box.setInformativeText(is_new ? tr("Save it as a scene file, or discard it?")
                                : tr("Save them as a scene file, or discard them?"));
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return saveBeforeLeaving();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

bool SceneFiles::saveBeforeLeaving() {
  const QString path =
      QFileDialog::getSaveFileName(window_, tr("Save the tuned scene"), placeToSave(document_), filterText());
  return !path.isEmpty() && saveAs(path);
}

}  // namespace underact::gui
