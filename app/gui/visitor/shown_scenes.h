#pragma once
#include <QString>
#include <QStringList>
#include <vector>

#include "core/base/task_monitor.h"
#include "core/scene/description.h"
#include "core/scene/teaching.h"
#include "core/target/curve_target.h"

namespace underact::gui {

/// A scene ready to be felt, with its meshes and its description.
struct ShownScene {
  scene::Description scene;
  QString title, feel, try_this;
  std::vector<target::CurvePath> curves = {};  // kept so that they are not made again
};

struct ShownScenes {
  std::vector<ShownScene> scenes;
  QStringList refused;  // file names of those that cannot be shown
};

/// Reads and loads all of them. Takes a while, so do not call it in the window's thread. left_handed: mirrored.
ShownScenes loadShownScenes(const QStringList& paths, bool left_handed, const TaskMonitor& monitor);

}  // namespace underact::gui
