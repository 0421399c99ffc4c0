#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::mesh {

/// Which part of a triangle ABC a point of it is on.
enum class Part : std::uint8_t { Inside, EdgeAB, EdgeBC, EdgeCA, CornerA, CornerB, CornerC };

/// What onTriangle() gives, in the unit and frame of its corners.
struct OnTriangle {
  Vec3 p_M;                  // the point
  double squared = 0.0;      // of its distance from q
  Part part = Part::Inside;  // the smallest part it is on
};

/// The point of the triangle ABC nearest to q; p_MA, p_MB, p_MC: its corners; all finite, any unit. Holds for triangles
/// without area, too: then it is on an edge or a corner. Within 1e-15 of the largest coordinate off
/// the triangle, and as much farther than the nearest. Source: Ericson 2005, Real-Time Collision Detection,
/// section 5.1.5.
OnTriangle onTriangle(const Eigen::Vector3f& p_MA, const Eigen::Vector3f& p_MB, const Eigen::Vector3f& p_MC,
                      const Vec3& q) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
