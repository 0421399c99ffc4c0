#pragma once
#include <functional>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_maker {

/// A piece of a surface as rows of points, across by along cells, two triangles each; half: of a triangle's shape, the
/// points with i + j <= across alone. Seen from outside, along is to the left of across.
struct Patch {
  int across = 1;
  int along = 1;
  bool half = false;
  std::function<Vec3(int i, int j)> at;  // 0 to across, 0 to along
  int faces() const { return half ? across * across : 2 * across * along; }
};

int facesOf(const std::vector<Patch>& patches);

/// The patches' triangles, where corners at the very same place (in floats) are one.
mesh::Triangles joined(const std::vector<Patch>& patches);

/// What `patches` gives for the size of cell that comes nearest to that many faces on so large a surface.
mesh::Triangles ofFaces(int faces, double area_mm2, const std::function<std::vector<Patch>(double cell_mm)>& patches);

/// How often a length is cut.
int cuts(double length_mm, double cell_mm);

/// One axis of a solid of straight edges: where its parts begin, and all points that cut them.
struct Ruler {
  Ruler(const std::vector<double>& breaks, const std::vector<int>& cuts);
  std::vector<double> points;
  std::vector<int> starts;  // of each part, and the end: indexes of points
};

/// Parts from, from + 1 ... of a ruler, up to `to`.
struct Parts {
  int from;
  int to;
};

/// Three rulers, and what lies along their points. Axes: 0 x, 1 y, 2 z; w: what the third axis says; outward is the
/// direction of u x v.
struct Rulers {
  std::vector<Ruler> all;

  Vec3 at(int u, int v, double on_u, double on_v, double w) const;
  /// Parts of a plane.
  Patch flat(int u, int v, double w, Parts u_parts, Parts v_parts) const;
  /// Parts of a plane about a round hole in their midst.
  Patch ring(int u, int v, double w, Parts u_parts, Parts v_parts, double radius_mm, int along) const;
  /// The wall of that hole, from a lower w up to a higher one by a ruler of the third axis; u x v must be that axis.
  Patch holeWall(int u, int v, Parts w_parts, Parts u_parts, Parts v_parts, double radius_mm) const;

 private:
  std::vector<Eigen::Vector2d> rim(int u, int v, Parts u_parts, Parts v_parts) const;
  Eigen::Vector2d onHole(int u, int v, Parts u_parts, Parts v_parts, double radius_mm,
                         const Eigen::Vector2d& rim) const;
  const Ruler& ruler(int axis) const { return all[static_cast<std::size_t>(axis)]; }
};

}  // namespace underact::mesh_maker
