#pragma once
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/mesh_union/grid.h"

namespace underact::mesh_union {

/// The points of an arrangement of triangles, exact: corners of the mesh, and where its edges and planes meet. A point
/// has one number however it was found.
class Points {
 public:
  explicit Points(const Grid& grid);

  /// Of a corner of the mesh: the first one at its place.
  std::int32_t ofCorner(std::int32_t corner) const { return of_corner_[static_cast<std::size_t>(corner)]; }
  /// Where the edge from p to q, corners on different sides of the plane, goes through it.
  std::int32_t onEdge(std::int32_t p, std::int32_t q, const Plane& plane);
  /// Where three planes meet; -1: in no point.
  std::int32_t ofPlanes(const Plane& a, const Plane& b, const Plane& c);

  /// A point that is none of the arrangement's, below 2^28 in magnitude; equal to no other.
  std::int32_t beside(const GridPoint& p);

  std::size_t count() const { return near_.size(); }
  std::size_t corners() const { return of_corner_.size(); }
  /// In steps of the grid, within 2^-24 of one.
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
