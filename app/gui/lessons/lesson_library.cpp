#include "app/gui/lessons/lesson_library.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QUrl>
#include <algorithm>

#include "app/gui/kit/shipped.h"
#include "app/gui/model/data_words.h"
#include "core/lesson/read.h"

namespace underact::gui {
namespace {

const QString kSolved = "lessons/solved";  // group of the settings

/// A settings key. Paths are encoded, since slashes separate groups there; a shipped lesson goes by its name, wherever
/// it is installed.
QString keyOf(const QString& path) {
  const QFileInfo file(path);
  const bool ships = file.absolutePath() == lessonFolder();
  const QString name = ships ? file.completeBaseName() : file.absoluteFilePath();
  return kSolved + ('/' + QString::fromLatin1(QUrl::toPercentEncoding(name)));
}

}  // namespace

QString lessonFolder() {
  return shippedFolder(system::Resource::Lessons);
}

std::vector<lesson::Lesson> shippedLessons() {
  std::vector<lesson::Lesson> lessons;
  for (const QFileInfo& file : QDir(lessonFolder()).entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
    if (file.fileName().endsWith("schema.json")) continue;
    Result<lesson::Lesson> read = lesson::readLessonFile(file.absoluteFilePath().toStdString());
    if (read) lessons.push_back(translated(std::move(read).value()));
  }
  std::stable_sort(lessons.begin(), lessons.end(),
                   [](const lesson::Lesson& a, const lesson::Lesson& b) { return a.order < b.order; });
  return lessons;
}

const lesson::Lesson* lessonAfter(const std::vector<lesson::Lesson>& lessons, const QString& path) {
  const auto here = std::find_if(lessons.begin(), lessons.end(), [&](const lesson::Lesson& one) {
    return QFileInfo(QString::fromStdString(one.file)) == QFileInfo(path);
  });
  return here == lessons.end() || here + 1 == lessons.end() ? nullptr : &*(here + 1);
}

QString lessonPath(const QString& name) {
  if (name.contains('/') || name.endsWith(".json")) return QFileInfo(name).absoluteFilePath();
  return QDir(lessonFolder()).filePath(name + ".json");
}

QSet<std::size_t> solvedSteps(const QString& path) {
  QSet<std::size_t> steps;
  for (const QString& step : QSettings().value(keyOf(path)).toStringList()) steps.insert(step.toULongLong());
  return steps;
}

void rememberSolved(const QString& path, std::size_t step) {
  QSettings stored;
  QStringList steps = stored.value(keyOf(path)).toStringList();
  if (steps.contains(QString::number(step))) return;
  stored.setValue(keyOf(path), steps << QString::number(step));
}

void forgetSolved() {
  QSettings().remove(kSolved);
}

}  // namespace underact::gui
