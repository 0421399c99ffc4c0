#pragma once
#include "app/gui/gallery/figure_list.h"

namespace underact::gui {

/// Writes a figure as a PDF file: the print version or, if there is only a picture, the picture on a page of its size,
/// 7 inches wide. Returns the error; empty: written.
QString saveFigurePdf(const FigureRow& row, const QString& path);

}  // namespace underact::gui
