#include "app/gui/model/recorded_files.h"

#include <QFileInfo>
#include <QSettings>

#include "app/gui/model/scene_library.h"

namespace underact::gui {
namespace {

constexpr const char* kFolders = "replay/files";
constexpr const char* kRecentScenes = "files/recent";
constexpr qsizetype kMaxFolders = 8;

}  // namespace

std::vector<std::string> recordedFilesFolders() {
  const QSettings stored;
  QStringList folders = stored.value(kFolders).toStringList();
  for (const QString& scene : stored.value(kRecentScenes).toStringList()) folders << QFileInfo(scene).absolutePath();
  folders << sceneFolder();
  folders.removeDuplicates();
  std::vector<std::string> all;
  for (const QString& folder : folders) {
    if (!folder.isEmpty()) all.push_back(folder.toStdString());
  }
  return all;
}

void rememberRecordedFiles(const QString& folder) {
  QSettings stored;
  QStringList folders = stored.value(kFolders).toStringList();
  folders.removeAll(folder);
  folders.prepend(folder);
  stored.setValue(kFolders, folders.mid(0, kMaxFolders));
}

}  // namespace underact::gui
