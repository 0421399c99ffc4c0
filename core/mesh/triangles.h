#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/types.h"

namespace underact::mesh {

/// Three corners, counterclockwise as seen from outside.
using Face = std::array<std::int32_t, 3>;

/// A triangle mesh as a file holds it: in its own frame M and its own unit (the scene's scale_mm_per_unit gives its
/// length), in floats, as the formats and OpenMesh have it. Results computed from them in doubles are exact relative to
/// the coordinates as loaded.
struct Triangles {
  std::vector<Eigen::Vector3f> p_MV;  // corners, units
  std::vector<Face> faces;            // indexes of p_MV
};

/// corner: an index of p_MV, not checked.
inline Vec3 cornerAt(const Triangles& triangles, std::int32_t corner) {
  return triangles.p_MV[static_cast<std::size_t>(corner)].cast<double>();
}

}  // namespace underact::mesh
