#pragma once
#include "core/mesh_union/boxes.h"

namespace underact::mesh_union {

/// How often a closed mesh winds around a point: in how many of its bodies the point is.
/// Source: Jacobson, Kavan and Sorkine-Hornung 2013, Robust inside-outside segmentation using generalized winding
/// numbers. Counts the faces that a ray passes through; sums solid angles if eight rays all pass near edges.
class Winding {
 public:
  /// plane_of: of each face; equal ones lie in one plane; -1: it has no area.
  Winding(const Grid& grid, const std::vector<mesh::Face>& faces, const Boxes& boxes,
          const std::vector<std::int32_t>& plane_of)
      : grid_(grid), faces_(faces), boxes_(boxes), plane_of_(plane_of) {}

  /// The number just in front of a point inside a piece of the plane's faces. out: the normal of the piece, unit.
  /// times: by how much greater it is just behind the piece.
  int before(const Vec3& point, const Vec3& out, std::int32_t plane, int times) const;

 private:
  bool byRay(const Vec3& point, const Vec3& along, std::int32_t plane, int& sum) const;
  int byAngles(const Vec3& point, std::int32_t plane, int times) const;
  std::array<Vec3, 3> from(const Vec3& point, std::int32_t face) const;
  const Grid& grid_;
  const std::vector<mesh::Face>& faces_;
  const Boxes& boxes_;
  const std::vector<std::int32_t>& plane_of_;
};

}  // namespace underact::mesh_union
