#pragma once
#include <string>

#include "core/mesh/triangles.h"

namespace underact::mesh_maker {

/// A mesh as the bytes of a file, the same on every machine (numbers in little-endian order).
std::string asStl(const mesh::Triangles& triangles);  // binary: corners again in each face, with its normal
std::string asPly(const mesh::Triangles& triangles);  // binary
std::string asObj(const mesh::Triangles& triangles);  // text, the shortest that reads back to the same floats

}  // namespace underact::mesh_maker
