#pragma once
#include <unordered_map>
#include <vector>

#include "core/mesh_union/points.h"

namespace underact::mesh_union {

/// A triangle in its plane, divided into triangles so that given segments are edges. All decisions are exact.
/// Source: Sloan 1993, A fast algorithm for generating constrained Delaunay triangulations, without its Delaunay part.
class Cells {
 public:
  /// One triangle of the division.
  struct Cell {
    std::array<std::int32_t, 3> corners{};           // points, counterclockwise along the axis
    std::array<std::int32_t, 3> beside{-1, -1, -1};  // across the edge from each corner to the next
    std::array<std::int32_t, 3> cut{-1, -1, -1};     // whose segment the edge is on; -1: none, so it may be flipped
  };

  /// own: the plane; domain: points, counterclockwise along axisOf(own).
  Cells(Points& points, const Plane& own, const std::array<std::int32_t, 3>& domain);

  /// Adds a point of the domain as a corner.
  void add(std::int32_t point);
  /// Makes the segment between two points that were added an edge, or several. cut: the plane that it lies in. Where it
  /// crosses another segment, there is a new point on both.
  void constrain(std::int32_t from, std::int32_t to, const Plane& cut);
  /// Flips edges that may be flipped so that cells have larger angles.
  void improve();

  /// All triangles.
  const std::vector<Cell>& all() const { return cells_; }
  /// A limit of work was exceeded, so the result must not be used; not known to happen.
  bool hasFailed() const { return has_failed_; }

 private:
  struct Edge {
    std::int32_t cell = -1;
    std::size_t side = 0;
  };
  struct Path {                                       // from a point towards another one
    std::int32_t end = -1;                            // the first point on it that is a corner of a cell
    std::vector<std::array<std::int32_t, 2>> across;  // edges that it crosses before, right to left
    Edge blocked;                                     // the first of them that may not go
  };
  Cell& at(std::int32_t cell) { return cells_[static_cast<std::size_t>(cell)]; }
  int turn(std::int32_t a, std::int32_t b, std::int32_t c) const { return points_.turn(axis_, a, b, c); }
  std::vector<Edge> around(std::int32_t point);
  Edge edgeOf(std::int32_t a, std::int32_t b);
  Path pathBetween(std::int32_t from, std::int32_t to);
  void clear(std::int32_t from, const Path& path);
  void mark(std::int32_t a, std::int32_t b, std::int32_t cut);
  void put(std::int32_t cell);
  std::int32_t cellOf(std::int32_t point);
  void splitEdge(const Edge& edge, std::int32_t point);
  bool canFlip(const Edge& edge);
  std::array<std::int32_t, 2> flip(const Edge& edge);
  Points& points_;
  Plane own_;
  std::size_t axis_;
  std::vector<Cell> cells_;
  std::vector<Plane> cuts_;
  std::unordered_map<std::int32_t, std::int32_t> cell_of_;  // some cell that has the point as a corner
  std::int32_t last_ = 0;
  bool has_failed_ = false;
};

}  // namespace underact::mesh_union
