#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/curve/curve.h"
#include "core/curve/found.h"

namespace underact::curve {

/// Offers the point of a piece nearest to q_W, m, if it is within the limit, and every other minimum that is.
///
/// Of a line: the foot, clamped to its ends; exact. Of a cubic: half the derivative of the squared distance, (p -
/// q).p', is a quintic. The partial sums of its Bernstein coefficients are the coefficients of the squared distance;
/// their least is a lower bound. A part whose bound is beyond the limit is left out; one whose coefficients have one
/// sign has its minimum at an end; one whose coefficients increase has one minimum, which Newton's method (with
/// bisection) finds; any other is halved. Parts that cannot improve on the best by kFlat of it are flat and are
/// represented by their nearer end: so a cubic that is nearly a circle about q costs one visit. Error of the distance:
/// kFlat / 2 of it and the rounding of the coordinates (2^-49 of the largest); less for a part that is kSmallest of its
/// piece and still undecided, whose derivative therefore vanishes to second order.
void seekOnPiece(const Curve& curve, std::int32_t piece, const Vec3& q_W, Found& found) noexcept UNDERACT_REAL_TIME;

inline constexpr double kFlat = 1e-13;
inline constexpr int kMaxParts = 32;  // that wait: each halving leaves one
inline constexpr double kSmallest = 0x1p-30;

}  // namespace underact::curve
