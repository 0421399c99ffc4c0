#pragma once
#include <array>

#include "tests/error_bounds/oracle/real.h"

namespace underact::error_bounds::oracle {

// The nearest points of shapes, from their definitions, independent of core/shape. Axes need not be unit.

/// The nearest point, and how far the tip is from it; same unit as the arguments.
struct Nearest {
  Real3 p_WP;
  Real distance;  // never negative
};

// Lengths in one unit, positions in W. Where several points are nearest, one of them. Axes and normals: not 0.
Nearest onSphere(const Real3& p_WC, const Real& radius, const Real3& p_WT);
Nearest onLine(const Real3& p_WC, const Real3& axis_W, const Real3& p_WT);
Nearest onPlane(const Real3& p_WC, const Real3& normal_W, const Real3& p_WT);
Nearest onCircle(const Real3& p_WC, const Real3& axis_W, const Real& radius, const Real3& p_WT);
Nearest onCylinder(const Real3& p_WC, const Real3& axis_W, const Real& radius, const Real3& p_WT);
/// Distance from the axis.
Real offAxis(const Real3& p_WC, const Real3& axis_W, const Real3& p_WT);

/// Of a segment; a = b is a point.
Nearest onSegment(const Real3& a, const Real3& b, const Real3& q);
/// Of a triangle, one without area among them.
Nearest onTriangle(const Real3& a, const Real3& b, const Real3& c, const Real3& q);
/// The solid angle, over 4 pi, that a triangle takes of the sphere about q, positive where its normal points away: the
/// sum over a closed surface is 1 inside and 0 outside. Source: van Oosterom and Strackee 1983.
Real shareOfSphere(const Real3& a, const Real3& b, const Real3& c, const Real3& q);
/// Of the parallelogram c + s u + t v, s and t in [-1, 1].
Nearest onParallelogram(const Real3& c, const Real3& u, const Real3& v, const Real3& q);
/// Of the surface of a solid c + sum of s_i edge_i, s_i in [-1, 1]: the nearest of six faces.
Nearest onSolid(const Real3& c, const std::array<Real3, 3>& edges, const Real3& q);
/// Whether q is inside of it.
bool isInSolid(const Real3& c, const std::array<Real3, 3>& edges, const Real3& q);

/// The distance of y from the ellipse or ellipsoid sum (x_i / semi_i)^2 = 1 about the origin: count 2 or 3. By
/// bisection of the multiplier, then Newton: no start value is needed, and only the centre is a special case.
Real toQuadric(const std::array<Real, 3>& semi, const std::array<Real, 3>& y, int count);

/// Three orthonormal vectors near the columns of R, by Gram-Schmidt.
std::array<Real3, 3> axesOf(const Mat3& R);

}  // namespace underact::error_bounds::oracle
