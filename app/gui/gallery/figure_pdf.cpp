#include "app/gui/gallery/figure_pdf.h"

#include <QFile>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

namespace underact::gui {
namespace {

constexpr double kWidth_in = 7.0;
constexpr int kPixels_per_in = 300;

bool writePicture(const QImage& image, const QString& title, const QString& path) {
  QPdfWriter writer(path);
  writer.setResolution(kPixels_per_in);
  writer.setTitle(title);
  const double height_in = kWidth_in * image.height() / image.width();
  writer.setPageSize(QPageSize(QSizeF(kWidth_in, height_in), QPageSize::Inch));
  writer.setPageMargins(QMarginsF());
  QPainter painter;
  if (!painter.begin(&writer)) return false;
  painter.drawImage(QRect(0, 0, writer.width(), writer.height()), image);
  return painter.end();
}

}  // namespace

QString saveFigurePdf(const FigureRow& row, const QString& path) {
  bool written = false;
  if (!row.pdf.isEmpty()) {
    QFile from(row.pdf), to(path);  // overwrites: the file dialog has asked
    written = from.open(QIODevice::ReadOnly) && to.open(QIODevice::WriteOnly) && to.write(from.readAll()) > 0;
  } else {
    const QImage image(row.picture);
    if (image.isNull()) return QObject::tr("Figure %1 has no picture.").arg(row.key);
    written = writePicture(image, QObject::tr("Figure %1: %2").arg(row.key, row.title), path);
  }
  return written ? QString() : QObject::tr("%1 could not be written. Choose another folder.").arg(path);
}

}  // namespace underact::gui
