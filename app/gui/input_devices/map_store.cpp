#include "app/gui/input_devices/map_store.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

namespace underact::gui {

MapStore::MapStore() : folder_(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/hands") {}

QString MapStore::pathOf(const std::string& id) const {
  QString name;
  for (const QChar letter : QString::fromStdString(id)) {
    const bool is_plain = letter.unicode() < 0x80 && (letter.isLetterOrNumber() || letter == '-');
    name += is_plain ? QString(letter) : QString("_%1").arg(letter.unicode(), 0, 16);  // names stay different
  }
  return folder_ + "/" + name.left(150) + ".json";
}

Result<std::optional<device::input::Map>> MapStore::load(const std::string& id) const {
  const QString path = pathOf(id);
  if (!QFileInfo::exists(path)) return std::optional<device::input::Map>();
  const Result<device::input::MapFile> read = device::input::readMapFile(path.toStdString());
  if (!read) return read.problems();
  return std::optional(read.value().map);
}

Problems MapStore::save(const device::input::MapFile& file) const {
  const QString path = pathOf(file.id);
  QDir().mkpath(folder_);
  QSaveFile out(path);
  const QByteArray text = QByteArray::fromStdString(device::input::mapText(file));
  if (out.open(QIODevice::WriteOnly) && out.write(text) == text.size() && out.commit()) return {};
  return Problems{{phrase(
      QT_TRANSLATE_NOOP("problem",
                        "The mapping could not be saved in %1: %2. It stays in effect until you close the window."),
      {path.toStdString(), out.errorString().toStdString()})}};
}

void MapStore::forget(const std::string& id) const {
  QFile::remove(pathOf(id));
}

}  // namespace underact::gui
