#pragma once
#include "app/gui/gallery/figure_list.h"

namespace underact::gui {

/// Writes a figure as a PDF file: as it was drawn for print, or, where there is only a picture, that on a page of its
/// size, 7 inches wide. Gives why it could not; empty: it is there.
QString saveFigurePdf(const FigureRow& row, const QString& path);

}  // namespace underact::gui
