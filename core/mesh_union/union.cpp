#include "core/mesh_union/union.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/mesh/topology.h"
#include "core/mesh_union/solid.h"
#include "core/mesh_union/tidy.h"

namespace underact::mesh_union {
namespace {

bool isCorner(const std::array<std::int32_t, 2>& between, const Points& points) {
  return between[0] == between[1] && static_cast<std::size_t>(between[0]) < points.corners();
}

Eigen::Vector3f placeOf(const std::array<std::int32_t, 2>& between, const mesh::Triangles& triangles, const Grid& grid,
                        const Points& points) {
  if (isCorner(between, points)) return triangles.p_MV[static_cast<std::size_t>(between[0])];
  const Vec3 middle = 0.5 * (points.near(between[0]) + points.near(between[1]));
  return (grid.centre_M + middle / grid.steps).cast<float>();
}

/// Floats far from the origin are far apart.
double minLengthOf(double min, const mesh::Triangles& triangles) {
  float largest = 0.0F;
  for (const Eigen::Vector3f& p : triangles.p_MV) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return std::max(min, 0x1p-21 * static_cast<double>(largest));
}

}  // namespace

Union unite(mesh::Triangles& triangles, double min, double wide, const TaskMonitor& monitor, const Limits& limits) {
  Union made;
  const auto ended = [&](Outcome outcome) {
    made.outcome = monitor.isCancelled() ? Outcome::Cancelled : outcome;
    return made;
  };
  Grid grid = gridOf(triangles.p_MV);
  widen(grid, triangles.faces, wide * grid.steps);
  const Boxes boxes(grid.points, triangles.faces);
  if (monitor.isCancelled()) return ended(Outcome::Cancelled);
  Points points(grid);
  const Arrangement arrangement = arrange(grid, triangles.faces, boxes, points, monitor, limits);
  made.crossings = arrangement.crossings;
  if (!arrangement.is_whole) return ended(Outcome::TooMuch);
  const std::optional<Kept> kept = keep(grid, triangles.faces, boxes, points, arrangement, monitor);
  if (!kept) return ended(Outcome::Open);
  made.dropped = kept->dropped;
  if (kept->is_all && mesh::topologyOf(triangles.faces).is_closed) return ended(Outcome::AsItWas);
  Solid solid = solidOf(kept->pieces, points);
  mesh::Triangles now{{}, std::move(solid.faces)};
  Made is_made;
  for (const std::array<std::int32_t, 2>& between : solid.between) {
    now.p_MV.push_back(placeOf(between, triangles, grid, points));
    is_made.corners.push_back(between[0] == between[1] && !isCorner(between, points) ? 1 : 0);
  }
  for (const std::int32_t piece : solid.piece_of)
    is_made.faces.push_back(kept->pieces[static_cast<std::size_t>(piece)].is_cut ? 1 : 0);
  tidy(now, is_made, minLengthOf(min, triangles));
  if (!mesh::topologyOf(now.faces).is_closed) return ended(Outcome::Open);  // or nothing is inside
  if (monitor.isCancelled()) return ended(Outcome::Cancelled);
  triangles = std::move(now);
  return ended(Outcome::Made);
}

}  // namespace underact::mesh_union
