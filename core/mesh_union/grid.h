#pragma once
#include <vector>

#include "core/mesh/triangles.h"
#include "core/mesh_union/big.h"

namespace underact::mesh_union {

/// A corner in whole steps of a grid: below 2^25 in magnitude, so that all decisions on intersections are exact.
using GridPoint = std::array<std::int64_t, 3>;

/// The corners of a mesh, each moved to the nearest point of a grid of 2^24 to 2^25 steps along its largest
/// extent: 3e-8 to 6e-8 of it. Coordinates are those from its centre.
struct Grid {
  Vec3 centre_M = Vec3::Zero();
  double steps = 1.0;  // a unit, a power of two
  std::vector<GridPoint> points;
};
/// p_MV: finite, in the unit of the mesh. None: an empty grid.
Grid gridOf(const std::vector<Eigen::Vector3f>& p_MV);

/// Moves each corner outwards along the mean of its faces' normals, so that all its faces move by that many steps (less
/// where they meet at a spike): gaps narrower than twice that between bodies close.
void widen(Grid& grid, const std::vector<mesh::Face>& faces, double steps);

/// n . x = d, in steps; n below 2^54, d below 2^81. n: the normal by the order of the corners, not of unit length.
struct Plane {
  std::array<std::int64_t, 3> n{};
  Wide d = 0;
  /// Not so of three collinear corners.
  bool isThere() const { return n[0] != 0 || n[1] != 0 || n[2] != 0; }
};
/// The plane through three corners.
Plane planeOf(const GridPoint& a, const GridPoint& b, const GridPoint& c);

/// The plane through a and b along the axis.
Plane planeAlong(const GridPoint& a, const GridPoint& b, std::size_t axis);

/// n . p - d: its sign tells the side of the plane.
Wide heightOf(const Plane& plane, const GridPoint& p);

/// The sign of the volume of abcd: above 0 if d is on the side from which a, b, c are counterclockwise.
int orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d);

/// The axis along which a plane is projected: that of the largest coordinate of its normal.
std::size_t axisOf(const Plane& plane);

/// Above 0: a, b, c are counterclockwise in the plane of the two axes that follow this one.
int turnOf(std::size_t axis, const GridPoint& a, const GridPoint& b, const GridPoint& c);

}  // namespace underact::mesh_union
