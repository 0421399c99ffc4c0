#pragma once
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/kit/background.h"
#include "core/base/result.h"
#include "core/base/task_monitor.h"
#include "core/scene/description.h"
#include "core/target/curve_target.h"

namespace underact::gui {

/// Reads scene files for others than the document and loads their meshes in another thread. Only the last request
/// counts.
class SceneLoading {
 public:
  struct Loaded {
    scene::Description scene;
    Problems problems;  // with its meshes; empty: usable
  };

  /// Problems: the file is not a valid scene; the current request continues.
  Problems begin(const QString& path);
  bool isLoading() const { return load_ != nullptr; }
  /// The result, once. Call it each frame.
  std::optional<Loaded> take();
  void cancel();

 private:
  std::unique_ptr<Background<Loaded>> load_;
  std::vector<std::unique_ptr<Background<Loaded>>> leaving_;  // left to finish by themselves
};

/// All loaded curves of a scene, built in advance: as long as they are held, compiling the scene reuses them. A spline
/// of a million points takes a second. Any thread.
std::vector<target::CurvePath> madeCurves(const scene::Description& scene, const TaskMonitor& monitor);

}  // namespace underact::gui
