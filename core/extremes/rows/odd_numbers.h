#pragma once
#include <array>
#include <limits>

#include "core/extremes/input.h"

namespace underact::extremes {

/// What no arm sends.
inline constexpr std::array<double, 14> kOddNumbers{
    kNotANumber, kInfinity, -kInfinity, 5e-324, -5e-324, 1e-310, 1e308,
    -1e308,      1e200,     -1e155,     1e-200, -0.0,    1e18,   std::numeric_limits<double>::max()};

inline double drawOdd(Dice& dice) {
  return kOddNumbers[dice.below(kOddNumbers.size())];
}

}  // namespace underact::extremes
