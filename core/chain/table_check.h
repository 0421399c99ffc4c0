#pragma once
#include <span>

#include "core/base/result.h"
#include "core/chain/dh.h"

namespace underact::chain {

inline constexpr double kLongestLink_m = 1.0;  // of a table that is drawn beside a hand

/// Why a DH table cannot be: no row or more than kMaxJoints, a number that is not finite or of no size a drawing has,
/// limits that leave no room. All of them, each with its row in place.line, from 1.
Problems impossibleIn(std::span<const DhRow> rows);

/// What can be and is hardly meant, row by row: a length below 0 along x, which the convention measures as a distance;
/// two joints that turn about one axis, or slide along one direction, of which one adds nothing; a tip that no joint
/// can move. Of a possible table. Source: Craig, Introduction to Robotics, 3rd ed., section 3.4.
Problems oddIn(std::span<const DhRow> rows);

}  // namespace underact::chain
