#pragma once
#include <QObject>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/scene/teaching.h"

namespace underact::gui {

/// A scene file as shown in the list.
struct SceneEntry {
  QString path;
  QString title;
  QString about;
  QString type;  // of its first constraint: "sphere"; empty: it cannot be read
  std::optional<scene::Teaching> teaching = {};
};

/// The entry of a file. If it cannot be read, its title is the file name; opening it says why.
SceneEntry sceneEntry(const QString& path);

/// The folder of the scenes that come with the program, as shippedFolder().
QString sceneFolder();

/// The thumbnail of a shipped scene; empty: none.
QString scenePicture(const QString& path, bool dark);

/// The scenes that come with the program, in teaching order (the order of their file names).
std::vector<SceneEntry> shippedScenes();

/// The first scene that a new user sees: the sphere. Empty: there are no scenes.
QString firstScene(const std::vector<SceneEntry>& scenes);

/// Recently opened files, the latest first, at most eight; missing files are left out.
class RecentFiles : public QObject {
  Q_OBJECT
 public:
  explicit RecentFiles(QObject* parent = nullptr) : QObject(parent) {}
  void set(const QStringList& paths);
  void add(const QString& path);
  QStringList paths() const { return paths_; }
 signals:
  void changed();

 private:
  QStringList paths_;
};

}  // namespace underact::gui
