#include "app/gui/files/tuned_scenes.h"

#include <QFileInfo>
#include <QSettings>
#include <QStringList>
#include <utility>

#include "core/scene/edit.h"
#include "core/scene/read.h"
#include "core/scene/write.h"

namespace underact::gui::tuned_scenes {
namespace {

QString tuningKey(const scene::Description& original) {
  return "tuned/" + QFileInfo(QString::fromStdString(original.file)).completeBaseName();
}

QString textOf(const scene::Description& scene) {
  return QString::fromStdString(scene::writeScene(scene));
}

}  // namespace

void keep(const scene::Description& original, const scene::Description& tuned) {
  if (scene::isSame(original, tuned))
    QSettings().remove(tuningKey(original));
  else
    QSettings().setValue(tuningKey(original), QStringList{textOf(original), textOf(tuned)});
}

std::optional<scene::Description> of(const scene::Description& original) {
  const QStringList texts = QSettings().value(tuningKey(original)).toStringList();
  if (texts.size() != 2 || texts.front() != textOf(original)) return {};
  Result<scene::Description> read = scene::readScene(texts.back().toStdString(), original.file);
  if (!read) return {};
  read.value().file = original.file;
  return std::move(read).value();
}

}  // namespace underact::gui::tuned_scenes
