#pragma once
#include <QColor>
#include <QPalette>

namespace underact::gui {

/// From 0, black, to 1, white. Source: WCAG 2.1, relative luminance.
double luminanceOf(const QColor& colour);

/// 1 where they are the same, 21 of black and white. Source: WCAG 2.1, contrast ratio.
double contrastOf(const QColor& a, const QColor& b);

/// The outline of what can be used, such as a box to tick or a field: 3:1 on everything it may stand on (WCAG 2.1,
/// 1.4.11).
QColor outlineColour(const QPalette& palette);

}  // namespace underact::gui
