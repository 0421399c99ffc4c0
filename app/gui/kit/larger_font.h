#pragma once
#include <QFont>
#include <algorithm>

namespace underact::gui {

/// The font scaled by a factor, whether its size is in points or pixels.
inline QFont larger(QFont font, double times) {
  if (font.pointSizeF() > 0.0)
    font.setPointSizeF(times * font.pointSizeF());
  else
    font.setPixelSize(std::max(1, qRound(times * font.pixelSize())));
  return font;
}

}  // namespace underact::gui
