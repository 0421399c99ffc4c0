#include "app/gui/model/scene_loading.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "core/scene/compile.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"

namespace underact::gui {

Problems SceneLoading::begin(const QString& path) {
  Result<scene::Description> read = scene::readSceneFile(path.toStdString());
  if (!read) return read.problems();
  cancel();
  load_ = std::make_unique<Background<Loaded>>([scene = std::move(read).value()](WorkState&) {
    Loaded loaded{scene, {}};
    if (scene::lacksMeshes(loaded.scene)) loaded.problems = scene::loadMeshes(loaded.scene);
    return loaded;
  });
  return {};
}

std::optional<SceneLoading::Loaded> SceneLoading::take() {
  leaving_.erase(std::remove_if(leaving_.begin(), leaving_.end(), [](auto& one) { return one->take().has_value(); }),
                 leaving_.end());
  std::optional<Loaded> loaded = load_ ? load_->take() : std::nullopt;
  if (loaded) load_.reset();
  return loaded;
}

void SceneLoading::cancel() {
  if (load_ != nullptr) leaving_.push_back(std::move(load_));
}

std::vector<target::CurvePath> madeCurves(const scene::Description& scene, const TaskMonitor& monitor) {
  std::vector<target::CurvePath> made;
  for (const scene::Constraint& constraint : scene.constraints) {
    const auto* const curve = std::get_if<scene::Curve>(&constraint.shape);
    if (curve == nullptr || curve->points == nullptr || monitor.isCancelled()) continue;
    monitor.report(QT_TRANSLATE_NOOP("step of work", "Joining the points"), 1.0);
    auto path = scene::makeCurvePath(*curve, constraint.place);
    if (path) made.push_back(std::move(path).value());  // otherwise compile() reports the problem
  }
  return made;
}

}  // namespace underact::gui
