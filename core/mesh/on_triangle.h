#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::mesh {

/// The part of a triangle ABC that a point is on.
enum class Part : std::uint8_t { Inside, EdgeAB, EdgeBC, EdgeCA, CornerA, CornerB, CornerC };

/// What onTriangle() gives, in the unit and frame of its corners.
struct OnTriangle {
  Vec3 p_M;                  // the point
  double squared = 0.0;      // of its distance from q
  Part part = Part::Inside;  // the part of lowest dimension
};

/// The point of the triangle ABC nearest to q; p_MA, p_MB, p_MC: its corners; all finite, any unit. Also for triangles
/// without area: then it is on an edge or a corner. Off the triangle by at most 1e-15 of the largest coordinate, and
/// farther from q than the nearest point by as much. Source: Ericson 2005, Real-Time Collision Detection, section
/// 5.1.5.
OnTriangle onTriangle(const Eigen::Vector3f& p_MA, const Eigen::Vector3f& p_MB, const Eigen::Vector3f& p_MC,
                      const Vec3& q) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
