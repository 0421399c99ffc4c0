#pragma once
#include <algorithm>
#include <cmath>

namespace underact::test {

/// A colour's relative luminance, 0 black to 1 white. red, green, blue: sRGB, 0 to 1. Source: WCAG 2.1.
inline double luminance(double red, double green, double blue) {
  const auto linear = [](double share) {
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
}

/// Of two colours with red, green and blue from 0 to 1: 1 where they are the same, 21 of black and white.
template <class Colour>
double contrast(const Colour& a, const Colour& b) {
  const double one = luminance(a.redF(), a.greenF(), a.blueF()), other = luminance(b.redF(), b.greenF(), b.blueF());
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

}  // namespace underact::test
