#pragma once
#include <cstdint>
#include <string>

#include "core/base/sentence.h"
#include "core/mesh_file/format.h"

namespace underact::mesh_reader {

/// A file as OpenMesh is given it: of the same format, with corners and faces alone, in the plainest of the ways in
/// which they may be written. What its readers take for granted (lengths, counts, lines, numbers that are numbers) is
/// so.
struct Prepared {
  std::string bytes;
  std::uint64_t corners = 0, faces = 0;  // that it holds; corners: 0 where the format shares none
  Sentence problem;                      // empty: none
};

/// What stands for a coordinate that is not a number or not finite.
inline constexpr const char* kNoNumber = "3e38";
inline constexpr float kNoNumberValue = 3e38F;

Prepared prepareStlBinary(std::string bytes);
Prepared prepareStlText(const std::string& bytes);
Prepared prepareObj(const std::string& bytes);
Prepared preparePly(const std::string& bytes);
Prepared prepareOff(const std::string& bytes);

Prepared prepare(mesh_file::Format format, std::string bytes);

}  // namespace underact::mesh_reader
