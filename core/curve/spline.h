#pragma once
#include <vector>

#include "core/base/types.h"

namespace underact::curve {

/// The controls of the centripetal Catmull-Rom spline through points_W (no two neighbours equal; closed: the first not
/// repeated, the end then is the first point again): four for each piece, neighbours sharing one.
///
/// Why this one: at each point its tangent bisects the directions of the two chords (with |chord| the square of a
/// knot's interval, the derivative (P1 - P0)/d1 - (P2 - P0)/(d1 + d2) + (P2 - P1)/d2 is (e1 + e2) d1 d2 / (d1 + d2), e
/// the chords' directions), so it never jumps; no handle is longer than 2/3 of its chord, so a piece does not leave the
/// neighbourhood of its chord, however unequal the chords are; it has no cusp or loop between two points; and a point
/// moves four pieces, not all. A C2 spline has a curvature that does not jump either, but pays with swings that run on
/// past each sharp turn: a hand feels a path that is not there, and does not feel where a curvature begins.
/// An open end starts along its chord: no swing there either.
/// Source: Barry and Goldman 1988; Yuksel, Schaefer, Keyser 2011, Parameterization and applications of Catmull-Rom
/// curves.
///
/// A piece whose arc length eight points of quadrature do not have to 1e-9 of its chord is made two, to kMostHalvings.
std::vector<Vec3> splineControls(const std::vector<Vec3>& points_W, bool closed);

/// Only beside a point where the path all but turns back, and its speed all but vanishes, are as many needed; what is
/// left there is below 1e-6 of the piece between the two points.
inline constexpr int kMostHalvings = 6;

}  // namespace underact::curve
