#pragma once
#include <QFont>
#include <algorithm>

namespace underact::gui {

/// The font at so many times its size, whether that was given in points or in pixels.
inline QFont larger(QFont font, double times) {
  if (font.pointSizeF() > 0.0)
    font.setPointSizeF(times * font.pointSizeF());
  else
    font.setPixelSize(std::max(1, qRound(times * font.pixelSize())));
  return font;
}

}  // namespace underact::gui
