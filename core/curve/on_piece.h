#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/curve/curve.h"
#include "core/curve/found.h"

namespace underact::curve {

/// Offers the point of a piece nearest to q_W, m, where it is within the limit, and every other minimum that is.
///
/// Of a line: the foot, held to its ends; exact.
/// Of a cubic: half the slope of the squared distance, (p - q).p', is a quintic. In Bernstein's form its coefficients,
/// added up, are those of the squared distance itself; their least is a lower bound. A part whose bound is beyond the
/// limit is left; one whose coefficients have one sign has its least at an end, one whose coefficients rise has one
/// minimum, and Newton's steps (with halvings) find it; any other is halved. Parts that cannot be better than the best
/// by kFlat of it are flat and stand for their nearer end: so a cubic that is all but a circle about q costs one visit.
/// Error of the distance: kFlat / 2 of it and the rounding of the coordinates (2^-49 of the largest); of a part that is
/// kSmallest of its piece and still undecided, whose slope therefore is 0 to second order, less than that.
void seekOnPiece(const Curve& curve, std::int32_t piece, const Vec3& q_W, Found& found) noexcept UNDERACT_REAL_TIME;

inline constexpr double kFlat = 1e-13;
inline constexpr int kMostParts = 32;  // that wait: each halving leaves one
inline constexpr double kSmallest = 0x1p-30;

}  // namespace underact::curve
