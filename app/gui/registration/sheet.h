#pragma once
#include <QPainter>
#include <QString>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"

namespace underact::gui {

enum class Paper { A4, Letter };

/// The position of a reference point on the page, mm from its upper left corner; the points are centred on the page.
QPointF onPage(const Vec3& p_D, const std::vector<Vec3>& points_D, const QSizeF& page_mm);

/// Paints the sheet, one unit of the painter per millimetre of the page: each reference point as a cross in a ring with
/// its number, and a ruler of 100 mm to check that it was printed at 100 %.
void paintSheet(QPainter& painter, const std::vector<Vec3>& points_D, const QSizeF& page_mm);

/// Saves it as a PDF, at its true size. Problems: the points differ in height or do not fit on the paper, or the file
/// cannot be written.
Problems saveSheet(const QString& path, const std::vector<Vec3>& points_D, Paper paper);

}  // namespace underact::gui
