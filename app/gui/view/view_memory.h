#pragma once
#include <QString>
#include <QStringList>

namespace underact::gui {

class SceneView;

/// How the view of each scene file was left: it looks so again when the scene is opened the next time. Views that were
/// not moved by hand are not kept: they fit whatever the scene is. The latest kMax are stored in the user's settings.
class ViewMemory {
 public:
  static constexpr int kMax = 60;

  explicit ViewMemory(SceneView& view);
  /// The scene of that file is in the view now; empty: one without a file, whose view is not kept.
  void enter(const QString& path);
  /// Keeps the view of the scene that is in it.
  void keep();

 private:
  SceneView& view_;
  QString path_;
  QStringList rows_;  // the latest first: a path, a tab, numbers
};

}  // namespace underact::gui
