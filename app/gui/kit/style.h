#pragma once
#include <QString>

#include "app/gui/kit/theme.h"

namespace underact::gui {

/// What the palette cannot say: quiet and loud labels, the titles of docks, the border of Stop. Sizes follow the font.
QString styleSheet(const Theme& theme);

}  // namespace underact::gui
