#pragma once
#include "core/mesh/proxy.h"
#include "tests/support/random.h"

namespace underact::test {

/// A tip that goes over a wall, and what the proxy of that wall does. Where the tip is free, it must be outside.
class Stroke {
 public:
  /// triangles: whose winding number tells inside from outside. surface: the wall. near: the tip may be free so far
  /// inside, in the unit of the mesh. Both outlive this.
  Stroke(const mesh::Triangles& triangles, const mesh::Surface& surface, double near)
      : triangles_(triangles), surface_(surface), near_(near) {}

  /// False: it is not outside, where a stroke begins.
  bool begin(const Vec3& q_M);
  /// On to q_M, in equal steps of step at most. False: the tip leaked.
  bool goTo(const Vec3& q_M, double step);
  /// Begins outside, up to 8 units from an aim, and goes through there and on in random directions, 3 times up to 6
  /// units, at 0.01 to 1.5 units a tick. False: the tip leaked.
  bool strike(const std::vector<Vec3>& aims, Random& random);
  int held() const { return held_; }  // ticks

 private:
  bool goOn(const Vec3& q_M);
  double distance(const Vec3& q_M) const;  // from the surface
  const mesh::Triangles& triangles_;
  const mesh::Surface& surface_;
  double near_;
  mesh::ProxyState state_;
  Vec3 q_M_ = Vec3::Zero();
  double clear_ = 0.0;  // how far the tip may go until it can reach a face
  int held_ = 0;
};

}  // namespace underact::test
