#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/mesh/triangles.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {

/// A cube of that edge, its corner at p, faces outward: 8 corners, 12 faces.
mesh::Triangles cube(float edge, const Eigen::Vector3f& p_MC = Eigen::Vector3f::Zero());

/// A ball of 8 * 4^levels faces, its corners on the sphere.
mesh::Triangles ball(float radius, int levels);

/// A flat square of n x n squares, n > 0, edge 1 each, in z = 0, upward.
mesh::Triangles sheet(int n);

/// Both, as one mesh.
mesh::Triangles joined(const mesh::Triangles& a, const mesh::Triangles& b);

/// Each face with corners of its own, as STL has them.
mesh::Triangles soup(const mesh::Triangles& triangles);

mesh::Triangles turnedOver(mesh::Triangles triangles);

double volumeOf(const mesh::Triangles& triangles);
double areaOf(const mesh::Triangles& triangles);

/// As files have them, written by hand.
std::string stlBinary(const mesh::Triangles& triangles, const std::string& head = "");
std::string stlText(const mesh::Triangles& triangles);
std::string obj(const mesh::Triangles& triangles);
std::string off(const mesh::Triangles& triangles);
std::string plyText(const mesh::Triangles& triangles);
std::string plyBinary(const mesh::Triangles& triangles, bool is_big = false);

/// The bytes of numbers, the low one first.
std::string bytesOf(const std::vector<float>& values);
std::string bytesOf(std::uint32_t value);

}  // namespace underact::test
