#pragma once
#include <vector>

#include "core/mesh/triangles.h"
#include "tests/support/random.h"

namespace underact::test {

/// Closed bodies, with their normals outwards.
mesh::Triangles boxOf(const Vec3& low, const Vec3& high);
mesh::Triangles wedgeOf(const Vec3& size);
mesh::Triangles roundOf(double radius, int levels);

mesh::Triangles moved(mesh::Triangles triangles, const Mat3& R, const Vec3& by);
/// One mesh of all, each with corners of its own.
mesh::Triangles together(const std::vector<mesh::Triangles>& parts);

/// 2 to max_parts boxes, wedges and balls, as bodies come with physics engines: rotated at random, or all along the
/// axes with integer coordinates, so that faces lie on each other and edges and corners meet.
mesh::Triangles drawnBody(Random& random, int max_parts);

/// The winding number of a mesh about q, by solid angles in long doubles; an integer if the mesh is closed and q is not
/// on a face.
long double windingOf(const mesh::Triangles& triangles, const Vec3& q);

/// How far q is from the nearest face.
double distanceOf(const mesh::Triangles& triangles, const Vec3& q);

}  // namespace underact::test
