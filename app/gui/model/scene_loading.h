#pragma once
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/kit/background.h"
#include "core/base/result.h"
#include "core/base/watch.h"
#include "core/scene/description.h"
#include "core/target/curve_target.h"

namespace underact::gui {

/// Scene files read for somebody beside the document, with their meshes in another thread. The last one that was asked
/// for is meant.
class SceneLoading {
 public:
  struct Loaded {
    scene::Description scene;
    Problems problems;  // of its meshes; empty: it can be used
  };

  /// Problems: the file is no scene; then what is on its way goes on.
  Problems begin(const QString& path);
  bool isLoading() const { return load_ != nullptr; }
  /// What was loaded, once. Call it each frame.
  std::optional<Loaded> take();
  void cancel();

 private:
  std::unique_ptr<Background<Loaded>> load_;
  std::vector<std::unique_ptr<Background<Loaded>>> leaving_;  // nobody waits for them
};

/// All curves of a scene that are loaded, so that whoever compiles it finds them made as long as they are held. A
/// spline of a million points takes a second. Any thread.
std::vector<target::CurvePath> madeCurves(const scene::Description& scene, const Watch& watch);

}  // namespace underact::gui
