#include "app/gui/model/session_paths.h"

#include <QDir>
#include <QFileInfo>
#include <QObject>
#include <QStandardPaths>

#include "core/system/private_file.h"

namespace underact::gui {
namespace {

constexpr qsizetype kLongestName = 40;  // of a scene, in a file name

/// Letters and digits separated by single hyphens: a name that every file system and shell accepts.
QString plainName(const QString& title) {
  QString name;
  for (const QChar letter : title.toLower()) {
    const bool plain = (letter >= 'a' && letter <= 'z') || letter.isDigit();
    if (plain)
      name += letter;
    else if (!name.isEmpty() && !name.endsWith('-'))
      name += '-';
  }
  name.truncate(kLongestName);
  while (name.endsWith('-')) name.chop(1);
  return name.isEmpty() ? QStringLiteral("session") : name;
}

}  // namespace

QString defaultSessionFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Underact/sessions";
}

QString newSessionFile(const QString& folder, const QDateTime& when, const QString& scene_title) {
  const QString stem = QDir(folder).filePath(when.toString("yyyy-MM-dd_HH-mm-ss_") + plainName(scene_title));
  QString path = stem + ".underact.h5";  // by which the desktop recognises a session
  const auto taken = [&path] { return QFileInfo::exists(path) || QFileInfo(path).isSymLink(); };
  for (int another = 2; taken(); ++another) path = QString("%1_%2.underact.h5").arg(stem).arg(another);
  return path;
}

QString prepareSessionFolder(const QString& folder) {
  const QFileInfo there(folder);
  if (there.exists() && !there.isDir())
    return QObject::tr("%1 is a file, not a folder. Choose another folder for the recordings.").arg(folder);
  if (!there.exists() && system::makePrivateFolder(folder.toStdString()) != 0)
    return QObject::tr("The folder %1 cannot be created. Choose another folder for the recordings.").arg(folder);
  if (!QFileInfo(folder).isWritable())
    return QObject::tr("The folder %1 is not writable. Choose another folder for the recordings.").arg(folder);
  return {};
}

}  // namespace underact::gui
