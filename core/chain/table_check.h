#pragma once
#include <span>

#include "core/base/result.h"
#include "core/chain/dh.h"

namespace underact::chain {

inline constexpr double kLongestLink_m = 1.0;  // of a table that is drawn beside a hand

/// Errors of a DH table: no row or more than kMaxJoints, a number that is not finite or too large to draw, limits
/// without a range. All at once, each with its row in place.line, from 1.
Problems tableErrors(std::span<const DhRow> rows);

/// Doubtful rows of a valid DH table: a negative length along x, which the convention measures as a distance; two
/// joints that rotate about one axis, or slide along one direction, so that one is redundant; a tip that no joint can
/// move. Source: Craig, Introduction to Robotics, 3rd ed., section 3.4.
Problems tableWarnings(std::span<const DhRow> rows);

}  // namespace underact::chain
