#include "app/gui/visitor/shown_scenes.h"

#include <QFileInfo>

#include "app/gui/model/data_words.h"
#include "app/gui/model/scene_loading.h"
#include "app/gui/view/drawn_mesh.h"
#include "core/scene/compile.h"
#include "core/scene/load_meshes.h"
#include "core/scene/mirror.h"
#include "core/scene/read.h"

namespace underact::gui {
namespace {

bool load(const QString& path, bool left_handed, const TaskMonitor& monitor, ShownScene& into) {
  Result<scene::Description> read = scene::readSceneFile(path.toStdString());
  if (!read || !scene::loadMeshes(read.value(), monitor).empty() || !scene::compile(read.value())) return false;
  into.scene = left_handed ? scene::mirrored(std::move(read).value()) : std::move(read).value();
  into.curves = madeCurves(into.scene, monitor);
  makeDrawnMeshes(into.scene, monitor);
  const scene::Teaching teaching = translated(scene::teachingOf(path.toStdString()).value_or(scene::Teaching{}));
  into.title = sceneText(into.scene.title);
  into.feel = teaching.feel.empty() ? sceneText(into.scene.about) : QString::fromStdString(teaching.feel);
  into.try_this = QString::fromStdString(teaching.try_this);
  return true;
}

}  // namespace

ShownScenes loadShownScenes(const QStringList& paths, bool left_handed, const TaskMonitor& monitor) {
  ShownScenes loaded;
  for (const QString& path : paths) {
    if (monitor.isCancelled()) break;
    ShownScene one;
    if (load(QFileInfo(path).absoluteFilePath(), left_handed, monitor, one))
      loaded.scenes.push_back(std::move(one));
    else
      loaded.refused << QFileInfo(path).fileName();
  }
  return loaded;
}

}  // namespace underact::gui
