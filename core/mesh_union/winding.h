#pragma once
#include "core/mesh_union/boxes.h"

namespace underact::mesh_union {

/// How often a closed mesh, or one that closes, winds around points: how many of its bodies a point is in.
/// Source: Jacobson, Kavan and Sorkine-Hornung 2013, Robust inside-outside segmentation using generalized winding
/// numbers. By the faces that a ray goes through; by solid angles where eight rays all come near edges.
class Winding {
 public:
  /// plane_of: of each face, those alike lie in one plane; -1: it has no area.
  Winding(const Grid& grid, const std::vector<mesh::Face>& faces, const Boxes& boxes,
          const std::vector<std::int32_t>& plane_of)
      : grid_(grid), faces_(faces), boxes_(boxes), plane_of_(plane_of) {}

  /// Just before a point inside a piece of the plane's faces. out: its normal, unit. times: by how much more it is just
  /// behind.
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
