#pragma once
#include <cstdint>
#include <string>

#include "core/base/sentence.h"
#include "core/mesh_file/format.h"

namespace underact::mesh_reader {

/// A file as OpenMesh gets it: the same format, with vertices and faces only, in the plainest notation. What OpenMesh's
/// readers assume (lengths, counts, lines, valid numbers) holds.
struct Prepared {
  std::string bytes;
  std::uint64_t corners = 0, faces = 0;  // of the file; corners: 0 where the format shares no vertices
  Sentence problem;                      // empty: none
};

/// Replaces a coordinate that is not a number or not finite.
inline constexpr const char* kNoNumber = "3e38";
inline constexpr float kNoNumberValue = 3e38F;

Prepared prepareStlBinary(std::string bytes);
Prepared prepareStlText(const std::string& bytes);
Prepared prepareObj(const std::string& bytes);
Prepared preparePly(const std::string& bytes);
Prepared prepareOff(const std::string& bytes);

Prepared prepare(mesh_file::Format format, std::string bytes);

}  // namespace underact::mesh_reader
