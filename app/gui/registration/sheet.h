#pragma once
#include <QPainter>
#include <QString>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"

namespace underact::gui {

enum class Paper { A4, Letter };

/// Where a mark of the desk lies on the page, mm from its upper left corner; the marks are in the page's middle.
QPointF onPage(const Vec3& p_D, const std::vector<Vec3>& marks_D, const QSizeF& page_mm);

/// The sheet, 1 unit of the painter a millimetre of the page: each mark as a cross in a ring with its number, a ruler
/// of 100 mm to see by whether it was printed at 100 %.
void paintSheet(QPainter& painter, const std::vector<Vec3>& marks_D, const QSizeF& page_mm);

/// As a PDF, at its true size. Problems: the marks do not lie flat, do not fit on the paper, or the file cannot be
/// written.
Problems saveSheet(const QString& path, const std::vector<Vec3>& marks_D, Paper paper);

}  // namespace underact::gui
