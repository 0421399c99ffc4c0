#include "app/gui/kit/contrast.h"

#include <algorithm>
#include <cmath>

#include "app/gui/kit/theme.h"

namespace underact::gui {

double luminanceOf(const QColor& colour) {
  const auto linear = [](double share) {
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrastOf(const QColor& a, const QColor& b) {
  const auto [less, more] = std::minmax({luminanceOf(a), luminanceOf(b)});
  return (more + 0.05) / (less + 0.05);
}

QColor outlineColour(const QPalette& palette) {
  constexpr double kOutline = 3.0;
  constexpr int kSteps = 40;
  const QColor ground = palette.color(QPalette::Window), ink = palette.color(QPalette::WindowText);
  for (int step = 1; step < kSteps; ++step) {
    const QColor line = mixed(ground, ink, static_cast<double>(step) / kSteps);
    bool is_seen = true;
    for (const QPalette::ColorRole role :
         {QPalette::Window, QPalette::Base, QPalette::AlternateBase, QPalette::Button, QPalette::ToolTipBase})
      is_seen = is_seen && contrastOf(line, palette.color(role)) >= kOutline;
    if (is_seen) return line;
  }
  return ink;
}

}  // namespace underact::gui
