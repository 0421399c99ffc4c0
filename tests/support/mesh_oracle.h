#pragma once
#include <vector>

#include "core/mesh/triangles.h"

namespace underact::test {

/// A mesh said a second time: every face is asked, in long doubles. Shares no line with core/mesh, which finds the
/// region of a face that a point belongs to; here the feet on its plane, edges and corners are all tried, and the least
/// distance counts.
class MeshOracle {
 public:
  explicit MeshOracle(const mesh::Triangles& triangles);

  /// The least distance from q_M to any face, and the point that is so near (of several, any).
  struct Nearest {
    double distance;
    Vec3 p_M;
  };
  Nearest nearest(const Vec3& q_M) const;
  double distance(const Vec3& q_M) const { return nearest(q_M).distance; }

  /// Whether rays from q_M leave the mesh once more than they enter it; for closed meshes, and points off the surface.
  /// A ray that comes near an edge tells nothing, and another is sent.
  bool isInside(const Vec3& q_M) const;

  /// Of all coordinates: what errors are relative to.
  double largest() const { return largest_; }

 private:
  using Wide = Eigen::Matrix<long double, 3, 1>;
  struct Corners {
    Wide a, b, c;
  };
  struct Capsule {  // about a face's longest edge: far ones need no closer look
    Vec3 p_MA, p_MB;
    double radius;
    double distance(const Vec3& q_M) const;  // from the edge
  };
  static Wide nearestOf(const Corners& face, const Wide& q_M);

  std::vector<Corners> faces_;
  std::vector<Capsule> capsules_;
  double largest_ = 0.0;
};

}  // namespace underact::test
