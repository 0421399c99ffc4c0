#pragma once
#include <vector>

#include "core/mesh/triangles.h"
#include "tests/support/random.h"

namespace underact::test {

/// The diagonal of the box about a mesh.
double diagonalOf(const mesh::Triangles& triangles);

/// Points of the surface, evenly over its area (or over its faces, where it has none), each moved up to `reach` in any
/// direction.
std::vector<Vec3> pointsNear(const mesh::Triangles& triangles, double reach, int count, Seed seed);

/// Points of the box about a mesh, half as large again.
std::vector<Vec3> pointsAbout(const mesh::Triangles& triangles, int count, Seed seed);

/// Where a hand is, millisecond by millisecond, that strokes the surface: smooth, at 0.1 to 0.5 m/s (slower where it
/// must turn), from about 2 mm inside to 5 mm outside. mm: how long a millimetre is in the mesh's unit.
std::vector<Vec3> handPath(const mesh::Triangles& triangles, double mm, int milliseconds, Seed seed);

}  // namespace underact::test
