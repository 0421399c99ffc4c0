#include "app/gui/gallery/figure_list.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace underact::gui {
namespace {

constexpr const char* kMark = "made.json";

QJsonDocument documentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()) : QJsonDocument();
}

std::optional<double> figureNumber(const QJsonValue& value) {
  return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

QString wholePath(const QDir& folder, const QString& name) {
  return name.isEmpty() ? QString() : folder.filePath(name);
}

FigureRow figureRow(const QJsonObject& object, const QDir& folder) {
  FigureRow row;
  row.key = object["figure"].toString();
  row.title = object["title"].toString();
  row.caption = object["caption"].toString();
  row.left_out = object["left_out"].toString();
  row.problem = object["problem"].toString();
  row.scene = wholePath(folder, object["scene"].toString());
  row.session = wholePath(folder, object["session"].toString());
  row.passed = object["passed"].toBool();
  for (const QJsonValue& value : object["pictures"].toArray()) {
    const QString path = wholePath(folder, value.toString());
    if (path.endsWith(".png")) row.picture = path;
    if (path.endsWith(".pdf")) row.pdf = path;
  }
  for (const QJsonValue& value : object["numbers"].toArray()) {
    const QJsonObject number = value.toObject();
    row.numbers.push_back({number["what"].toString(), number["unit"].toString(), figureNumber(number["measured"]),
                           figureNumber(number["expected"]), figureNumber(number["tolerance"]),
                           number["passed"].toBool()});
  }
  return row;
}

std::size_t failedIn(const FigureRow& row) {
  return static_cast<std::size_t>(
      std::count_if(row.numbers.begin(), row.numbers.end(), [](const FigureNumber& number) { return !number.passed; }));
}

}  // namespace

Result<FigureList> readFigures(const QString& folder) {
  const QDir dir(folder);
  const QString path = dir.filePath("figures.json");
  const SourceLocation place{path.toStdString()};
  if (!QFile::exists(path))
    return Problems{{phrase(QT_TRANSLATE_NOOP("problem", "The figures have not been made yet.")), place}};
  const QJsonDocument document = documentOf(path);
  if (!document.isArray() || document.array().isEmpty())
    return Problems{
        {phrase(QT_TRANSLATE_NOOP("problem", "The list of figures cannot be read. Make the figures again.")), place}};
  FigureList list;
  for (const QJsonValue& value : document.array()) list.rows.push_back(figureRow(value.toObject(), dir));
  const QJsonObject mark = documentOf(dir.filePath(kMark)).object();
  list.program_version = mark["program_version"].toString();
  list.made = QDateTime::fromString(mark["made"].toString(), Qt::ISODate);
  return list;
}

bool markFigures(const QString& folder, const QString& program_version, const QDateTime& made) {
  QFile file(QDir(folder).filePath(kMark));
  const QJsonObject mark{{"program_version", program_version}, {"made", made.toString(Qt::ISODate)}};
  return file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(mark).toJson()) > 0;
}

QString verdictOf(const FigureRow& row) {
  if (!row.problem.isEmpty()) return QObject::tr("not made");
  if (!row.left_out.isEmpty()) return QObject::tr("left out");
  if (row.numbers.empty()) return QObject::tr("picture of the view");
  const std::size_t failed = failedIn(row);
  return failed == 0 ? QObject::tr("all %1 numbers pass").arg(row.numbers.size())
                     : QObject::tr("%1 of %2 numbers fail").arg(failed).arg(row.numbers.size());
}

QString verdictOf(const FigureList& list) {
  std::size_t numbers = 0, failed = 0, left_out = 0;
  for (const FigureRow& row : list.rows) {
    numbers += row.numbers.size();
    failed += failedIn(row) + (row.problem.isEmpty() ? 0 : 1);
    left_out += row.left_out.isEmpty() ? 0 : 1;
  }
  QString verdict = QObject::tr("%1 figures, %2 numbers checked, %3.")
                        .arg(list.rows.size())
                        .arg(numbers)
                        .arg(failed == 0 ? QObject::tr("all pass") : QObject::tr("%1 failed").arg(failed));
  if (left_out > 0) verdict += ' ' + QObject::tr("Figures left out: %1.").arg(left_out);
  return verdict;
}

}  // namespace underact::gui
