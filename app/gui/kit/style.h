#pragma once
#include <QString>

#include "app/gui/kit/theme.h"

namespace underact::gui {

/// What the palette cannot express: quiet and loud labels, dock titles, the border of Stop. Sizes follow the font.
QString styleSheet(const Theme& theme);

}  // namespace underact::gui
