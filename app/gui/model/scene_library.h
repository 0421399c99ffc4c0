#pragma once
#include <QObject>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/scene/teaching.h"

namespace underact::gui {

/// A scene file as the list shows it.
struct SceneEntry {
  QString path;
  QString title;
  QString about;
  QString type;  // of its first constraint: "sphere"; empty: it cannot be read
  std::optional<scene::Teaching> teaching = {};
};

/// What a file says of itself. One that cannot be read has its file name for a title: opening it tells why.
SceneEntry sceneEntry(const QString& path);

/// The folder of the scenes that come with the program, as shippedFolder().
QString sceneFolder();

/// The small picture of a scene that comes with the program; empty: it has none.
QString scenePicture(const QString& path, bool dark);

/// The scenes that come with the program, in teaching order (that of their file names).
std::vector<SceneEntry> shippedScenes();

/// The first scene a new user sees: the sphere. Empty: there are none.
QString firstScene(const std::vector<SceneEntry>& scenes);

/// Files opened lately, the latest first, eight at most; files that are gone are left out.
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
