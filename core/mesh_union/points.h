#pragma once
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/mesh_union/grid.h"

namespace underact::mesh_union {

/// The points of an arrangement of triangles, exact: corners of the mesh, and intersections of its edges and planes. A
/// point has the same number however it was computed. The grid must outlive it.
class Points {
 public:
  /// Begins with the corners of the grid.
  explicit Points(const Grid& grid);

  /// The point of a corner of the mesh: the first corner at the same position.
  std::int32_t ofCorner(std::int32_t corner) const { return of_corner_[static_cast<std::size_t>(corner)]; }
  /// Where the edge from p to q, corners on different sides of the plane, passes through it.
  std::int32_t onEdge(std::int32_t p, std::int32_t q, const Plane& plane);
  /// Where three planes intersect; -1: not in one point.
  std::int32_t ofPlanes(const Plane& a, const Plane& b, const Plane& c);

  /// A point outside the arrangement, below 2^28 in magnitude; never equal to another.
  std::int32_t beside(const GridPoint& p);

  // Points altogether, and those of them that are corners of the mesh.
  std::size_t count() const { return near_.size(); }
  std::size_t corners() const { return of_corner_.size(); }
  /// Its position in steps of the grid, with an error below 2^-24 of a step.
  const Vec3& near(std::int32_t point) const { return near_[static_cast<std::size_t>(point)]; }
  /// As turnOf().
  int turn(std::size_t axis, std::int32_t a, std::int32_t b, std::int32_t c) const;

 private:
  struct Exact {
    Big x, y, z, w;  // the point is xyz / w, and w above 0
  };
  Exact exact(std::int32_t point) const;
  std::int32_t add(Exact point);
  std::int32_t append(const Exact& point);
  const Grid& grid_;
  std::vector<std::int32_t> of_corner_;
  std::vector<Vec3> near_;
  std::vector<Exact> made_;  // those after the corners
  std::unordered_multimap<std::uint64_t, std::int32_t> known_;
};

}  // namespace underact::mesh_union
