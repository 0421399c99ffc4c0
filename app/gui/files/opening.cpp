#include "app/gui/files/opening.h"

#include <QMimeData>
#include <QObject>
#include <QStringList>
#include <QUrl>

#include "app/gui/kit/words.h"
#include "app/gui/model/file_kind.h"

namespace underact::gui {
namespace {

QString whatDroppingDoes(FileKind kind) {
  switch (kind) {
    case FileKind::Scene:
      return QObject::tr("Drop to open the scene");
    case FileKind::Session:
      return QObject::tr("Drop to replay the session");
    case FileKind::Arm:
      return QObject::tr("Drop to give the scene this arm");
    case FileKind::Mesh:
      return QObject::tr("Drop to hold the stylus to this mesh");
    case FileKind::Curve:
      return QObject::tr("Drop to hold the stylus to this curve");
    case FileKind::Lesson:
      return QObject::tr("Drop to begin the lesson");
    case FileKind::Figures:
      return QObject::tr("Drop to look at these figures");
    case FileKind::Notebook:
      return QObject::tr("Drop to open the notebook in another program");
  }
  return {};
}

}  // namespace

QString filterOfAll() {
  QStringList patterns;
  for (const char* ending : {"json", "h5", "hdf5", "stl", "obj", "ply", "off", "urdf", "xml", "txt", "csv", "tsv",
                             "xyz", "pts", "asc", "dat", "ipynb"})
    patterns << QString("*.") + ending << "*." + QString(ending).toUpper();
  return QObject::tr("All that Underact opens (%1);;All files (*)").arg(patterns.join(' '));
}

Dragged draggedOf(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1) return {{}, QObject::tr("Drop one file at a time.")};
  if (!urls.first().isLocalFile())
    return {{}, QObject::tr("This is not on this computer. Download it, and drop the file.")};
  const QString path = urls.first().toLocalFile();
  const Result<FileKind> kind = kindOfFile(path.toStdString());
  return {path, kind ? whatDroppingDoes(kind.value()) : sentencesOf(kind.problems()), static_cast<bool>(kind)};
}

}  // namespace underact::gui
