#pragma once
#include "app/gui/kit/theme.h"

namespace underact::gui {

/// The colour, as far towards the ink as small words over the view need to be read: 4.5:1 (WCAG 2.1, 1.4.3).
QColor readable(const QColor& colour, const Theme& theme);

/// The ring around what has the focus: the colour of what is chosen, paler on a dark ground, where it stands on that
/// colour too.
QColor focusColour(const QPalette& palette);

}  // namespace underact::gui
