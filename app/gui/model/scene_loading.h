#pragma once
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/kit/background.h"
#include "core/base/result.h"
#include "core/scene/description.h"

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

}  // namespace underact::gui
