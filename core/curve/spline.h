#pragma once
#include <vector>

#include "core/base/types.h"

namespace underact::curve {

/// The controls of the centripetal Catmull-Rom spline through points_W (no two neighbours equal; closed: the first
/// point is not repeated, and the curve returns to it): four for each piece, of which neighbours share one.
///
/// Why this one: at each point its tangent bisects the directions of the two chords (with |chord| the square of a knot
/// interval, the derivative (P1 - P0)/d1 - (P2 - P0)/(d1 + d2) + (P2 - P1)/d2 is (e1 + e2) d1 d2 / (d1 + d2), e the
/// chords' directions), so it never jumps; no handle is longer than 2/3 of its chord, so a piece stays near its chord,
/// however unequal the chords are; it has no cusp or loop between two points; and a point affects four pieces, not all.
/// A C2 spline has continuous curvature, too, but oscillates past each sharp bend: a hand feels a path that is not
/// there, whereas it does not feel where a curvature begins. An open end starts along its chord, without oscillation.
/// Source: Barry and Goldman 1988; Yuksel, Schaefer, Keyser 2011, Parameterization and applications of Catmull-Rom
/// curves.
///
/// A piece whose arc length is not exact to 1e-9 of its chord with eight points of quadrature is halved, up to
/// kMaxHalvings times.
std::vector<Vec3> splineControls(const std::vector<Vec3>& points_W, bool closed);

/// As many are needed only next to a point where the path nearly turns back and its speed nearly vanishes; the
/// remaining error there is below 1e-6 of the piece between the two points.
inline constexpr int kMaxHalvings = 6;

}  // namespace underact::curve
