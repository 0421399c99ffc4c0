#include "app/gui/kit/contrast.h"

#include <algorithm>
#include <cmath>

namespace underact::gui {
namespace {

/// Source: WCAG 2.1, relative luminance.
double luminance(const QColor& colour) {
  const auto linear = [](double share) {
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

/// 1 where they are the same, 21 of black and white.
double contrast(const QColor& a, const QColor& b) {
  const auto [less, more] = std::minmax({luminance(a), luminance(b)});
  return (more + 0.05) / (less + 0.05);
}

}  // namespace

QColor readable(const QColor& colour, const Theme& theme) {
  constexpr double kWords = 4.5;
  constexpr int kSteps = 20;
  for (int step = 0; step < kSteps; ++step) {
    const QColor words = mixed(colour, theme.ink, static_cast<double>(step) / kSteps);
    if (contrast(words, theme.background) >= kWords) return words;
  }
  return theme.ink;
}

QColor focusColour(const QPalette& palette) {
  const bool is_dark = luminance(palette.color(QPalette::Window)) < luminance(palette.color(QPalette::WindowText));
  const QColor chosen = palette.color(QPalette::Highlight);
  return is_dark ? chosen.lighter(150) : chosen;
}

}  // namespace underact::gui
