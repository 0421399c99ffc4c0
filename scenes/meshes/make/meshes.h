#pragma once
#include "core/mesh/triangles.h"

// Meshes made by formula, in millimetres, about the origin: closed, oriented outwards, without zero faces or
// self-crossings, the same bytes on every machine. Scenes hold their files; tests and benchmarks make them larger.
namespace underact::mesh_maker {

using mesh::Triangles;

/// A (2, 3) torus knot: a tube of 14 mm along a curve that winds twice about z and thrice about a torus of radii 26 and
/// 12 mm; 90 mm across, 38 mm high, 9 mm of air between its strands. faces: 200 and more, met within 10 %.
Triangles torusKnot(int faces);

/// What the knot's tube follows, for those who check it.
inline constexpr double kKnotRing_mm = 26.0, kKnotWinding_mm = 12.0, kKnotTube_mm = 7.0;

/// A ball of radius 40 mm with round bumps 1.5 mm high, about 12 mm from crest to crest. faces: 20 n^2 for the n that
/// comes nearest.
Triangles bumpySphere(int faces);

inline constexpr double kBall_mm = 40.0, kBumpHeight_mm = 1.5, kBumpRadius_mm = 5.0;
inline constexpr int kBumps = 110;

/// An L of 90 x 60 x 50 mm, 8 mm thick, with a rib in its corner and two screw holes, of 14 mm in the foot and 9 mm in
/// the wall: sharp edges, concave corners, Euler number -2. faces: 500 and more, met within 10 %.
Triangles bracket(int faces);

/// A plate of 80 x 60 mm. thickness_mm: a multiple of 1/1024, so that floats and sums hold it.
Triangles plate(double thickness_mm, int faces);

/// A cube of 60 mm.
Triangles cube(int faces);

/// A block of 80 x 60 x 40 mm with a groove of 67 degrees along its top: a concave edge that a tip falls into.
Triangles wedge(int faces);

}  // namespace underact::mesh_maker
