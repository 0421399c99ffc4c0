#pragma once
#include <algorithm>
#include <cstdint>
#include <string>

#include "core/base/sentence.h"
#include "core/base/types.h"
#include "core/mesh_file/format.h"

namespace underact::mesh_reader {

/// A file as OpenMesh gets it: the same format, with vertices and faces only, in the plainest notation. What OpenMesh's
/// readers assume (lengths, counts, lines, valid numbers) holds.
struct Prepared {
  std::string bytes;
  std::uint64_t corners = 0, faces = 0;  // of the file; corners: 0 where the format shares no vertices
  Sentence problem;                      // empty: none
  Vec3 origin_M = Vec3::Zero();          // the point of the file's frame that is the origin of the bytes
  double single_step = 0.0;              // between single-precision numbers of the file, if it was moved; 0: none
};

/// How corners are moved before they become floats, which have large steps far from the origin; and their bounds as in
/// the file.
struct Shift {
  Vec3 origin_M = Vec3::Zero();  // is moved to the origin
  Vec3 low_M = Vec3::Constant(kInfinity), high_M = Vec3::Constant(-kInfinity);
  bool is_single = false;  // the file has them in single precision
  /// The moved coordinate.
  double take(int axis, double value) {
    low_M[axis] = std::min(low_M[axis], value);
    high_M[axis] = std::max(high_M[axis], value);
    return value - origin_M[axis];
  }
};

/// Replaces a coordinate that is not a number or not finite.
inline constexpr const char* kNoNumber = "3e38";
inline constexpr float kNoNumberValue = 3e38F;

Prepared prepareStlBinary(std::string bytes, Shift& shift);
Prepared prepareStlText(const std::string& bytes, Shift& shift);
Prepared prepareObj(const std::string& bytes, Shift& shift);
Prepared preparePly(const std::string& bytes, Shift& shift);
Prepared prepareOff(const std::string& bytes, Shift& shift);

/// Moves corners if the mesh is so far from its origin that floats there would lose more than some bits of its shape.
Prepared prepare(mesh_file::Format format, std::string bytes);

}  // namespace underact::mesh_reader
