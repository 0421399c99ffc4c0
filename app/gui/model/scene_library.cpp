#include "app/gui/model/scene_library.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/gui/kit/shipped.h"
#include "app/gui/model/data_words.h"
#include "core/scene/read.h"

namespace underact::gui {

constexpr qsizetype kMaxRecent = 8;

SceneEntry sceneEntry(const QString& path) {
  const Result<scene::Description> read = scene::readSceneFile(path.toStdString());
  if (!read)
    return {path, QFileInfo(path).fileName(), QObject::tr("This file cannot be read. Open it to see why."), {}};
  const scene::Description& scene = read.value();
  std::optional<scene::Teaching> teaching = scene::teachingOf(path.toStdString());
  if (teaching) teaching = translated(*std::move(teaching));
  return {path, sceneText(scene.title), sceneText(scene.about), scene::typeName(scene.constraints.front().shape),
          std::move(teaching)};
}

QString sceneFolder() {
  return shippedFolder(system::Resource::Scenes);
}

QString scenePicture(const QString& path, bool dark) {
  const QFileInfo scene(path);
  if (scene.absolutePath() != sceneFolder()) return {};
  for (const char* const folder :
       {"../pictures/scenes", "../resources/pictures/scenes"}) {  // installed; in the sources
    const QString picture =
        scene.dir().filePath(QString("%1/%2%3.png").arg(folder, scene.completeBaseName(), dark ? "_dark" : ""));
    if (QFileInfo::exists(picture)) return QDir::cleanPath(picture);
  }
  return {};
}

std::vector<SceneEntry> shippedScenes() {
  std::vector<SceneEntry> scenes;
  for (const QFileInfo& file : QDir(sceneFolder()).entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
    if (!file.fileName().endsWith("schema.json")) scenes.push_back(sceneEntry(file.absoluteFilePath()));
  }
  return scenes;
}

QString firstScene(const std::vector<SceneEntry>& scenes) {
  const auto sphere =
      std::find_if(scenes.begin(), scenes.end(), [](const SceneEntry& e) { return e.type == "sphere"; });
  if (sphere != scenes.end()) return sphere->path;
  return scenes.empty() ? QString() : scenes.front().path;
}

void RecentFiles::set(const QStringList& paths) {
  paths_.clear();
  for (const QString& path : paths) {
    if (QFileInfo::exists(path) && paths_.size() < kMaxRecent) paths_ << path;
  }
  emit changed();
}

void RecentFiles::add(const QString& path) {
  QStringList paths = paths_;
  paths.removeAll(path);
  paths.prepend(path);
  set(paths);
}

}  // namespace underact::gui
