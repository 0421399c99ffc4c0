#include "app/gui/registration/sheet.h"

#include <QFile>
#include <QPageSize>
#include <QPdfWriter>
#include <cmath>

#include "app/gui/kit/words.h"
#include "core/base/units.h"
#include "core/registration/sheet.h"

namespace underact::gui {
namespace {

constexpr double kRim_mm = 12.0;    // unprintable margin of printers, and the rings
constexpr double kWords_mm = 34.0;  // at the top and at the bottom
constexpr double kFlat_m = 1e-5;
constexpr int kDotsPerInch = 1200;
constexpr double kMillimetresPerInch = 25.4;

QRectF boundsOf(const std::vector<Vec3>& points_D) {
  QRectF bounds;
  for (std::size_t at = 0; at < points_D.size(); ++at) {
    const QPointF place(kMillimetrePerMetre * registration::rightOf(points_D[at]),
                        -kMillimetrePerMetre * registration::awayOf(points_D[at]));
    if (at == 0) bounds = QRectF(place, place);
    bounds.setLeft(std::min(bounds.left(), place.x()));
    bounds.setRight(std::max(bounds.right(), place.x()));
    bounds.setTop(std::min(bounds.top(), place.y()));
    bounds.setBottom(std::max(bounds.bottom(), place.y()));
  }
  return bounds;
}

void paintMark(QPainter& painter, const QPointF& at_mm, const QString& number) {
  painter.setPen(QPen(Qt::black, 0.25));
  painter.drawEllipse(at_mm, 3.0, 3.0);
  painter.drawLine(at_mm - QPointF(7.0, 0.0), at_mm + QPointF(7.0, 0.0));
  painter.drawLine(at_mm - QPointF(0.0, 7.0), at_mm + QPointF(0.0, 7.0));
  painter.drawText(QRectF(at_mm + QPointF(4.0, 3.0), QSizeF(12.0, 8.0)), Qt::AlignLeft | Qt::AlignTop, number);
}

void paintRuler(QPainter& painter, const QPointF& from_mm) {
  painter.drawLine(from_mm, from_mm + QPointF(100.0, 0.0));
  for (int tick = 0; tick <= 10; ++tick) {
    const QPointF at_mm = from_mm + QPointF(10.0 * tick, 0.0);
    painter.drawLine(at_mm, at_mm - QPointF(0.0, tick % 5 == 0 ? 4.0 : 2.0));
  }
}

}  // namespace

QPointF onPage(const Vec3& p_D, const std::vector<Vec3>& points_D, const QSizeF& page_mm) {
  const QPointF place(kMillimetrePerMetre * registration::rightOf(p_D),
                      -kMillimetrePerMetre * registration::awayOf(p_D));
  return place - boundsOf(points_D).center() + QPointF(0.5 * page_mm.width(), 0.5 * page_mm.height());
}

void paintSheet(QPainter& painter, const std::vector<Vec3>& points_D, const QSizeF& page_mm) {
  QFont font("Sans");
  font.setPixelSize(5);  // mm
  painter.setFont(font);
  painter.setPen(QPen(Qt::black, 0.25));
  const QRectF words(kRim_mm, kRim_mm, page_mm.width() - 2.0 * kRim_mm, kWords_mm - kRim_mm);
  painter.drawText(words, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                   tr("Underact: reference points for registering an arm. Print at 100 % and tape to the desk, the arm "
                      "behind or beside it. This edge faces away from you."));
  for (std::size_t at = 0; at < points_D.size(); ++at)
    paintMark(painter, onPage(points_D[at], points_D, page_mm), QString::number(at + 1));
  const QPointF ruler_mm(0.5 * page_mm.width() - 50.0, page_mm.height() - 20.0);
  paintRuler(painter, ruler_mm);
  painter.drawText(QRectF(ruler_mm + QPointF(0.0, 1.5), QSizeF(100.0, 7.0)), Qt::AlignHCenter | Qt::AlignTop,
                   tr("100 mm if printed at 100 %"));
}

Problems saveSheet(const QString& path, const std::vector<Vec3>& points_D, Paper paper) {
  const QPageSize page(paper == Paper::A4 ? QPageSize::A4 : QPageSize::Letter);
  const QSizeF page_mm = page.size(QPageSize::Millimeter);
  for (const Vec3& mark_D : points_D) {
    if (std::abs(registration::upOf(mark_D) - registration::upOf(points_D.front())) > kFlat_m)
      return {
          {phrase(QT_TRANSLATE_NOOP(
               "problem",
               "A sheet holds only reference points of equal height: at least one is higher or lower than point 1.")),
           {}}};
  }
  const QRectF bounds = boundsOf(points_D);
  if (bounds.width() > page_mm.width() - 4.0 * kRim_mm || bounds.height() > page_mm.height() - 2.5 * kWords_mm)
    return {
        {phrase(QT_TRANSLATE_NOOP("problem",
                                  "The reference points do not fit on this paper. Move them closer together, or draw "
                                  "them on the desk by hand.")),
         {}}};
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly))
    return {
        {phrase(QT_TRANSLATE_NOOP("problem", "The sheet cannot be written: %1."), {file.errorString().toStdString()}),
         {path.toStdString()}}};
  QPdfWriter writer(&file);
  writer.setPageSize(page);
  writer.setPageMargins(QMarginsF());
  writer.setResolution(kDotsPerInch);
  writer.setTitle(tr("Reference points for registering an arm"));
  QPainter painter(&writer);
  painter.scale(kDotsPerInch / kMillimetresPerInch, kDotsPerInch / kMillimetresPerInch);
  paintSheet(painter, points_D, page_mm);
  painter.end();
  file.close();
  if (file.error() != QFileDevice::NoError)
    return {
        {phrase(QT_TRANSLATE_NOOP("problem", "The sheet cannot be written: %1."), {file.errorString().toStdString()}),
         {path.toStdString()}}};
  return {};
}

}  // namespace underact::gui
