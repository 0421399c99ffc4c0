#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace underact::mesh_file {

/// How the body of the file holds its numbers.
enum class PlyEncoding : std::uint8_t { Text, LittleEndian, BigEndian };

/// One property of an element: a number, or a list of them with its length before it.
struct PlyProperty {
  std::string name;
  std::string type;  // of the number, or of a list's numbers, as OpenMesh knows them: "float", "uchar", ...
  int bytes = 0;     // of one
  bool is_list = false;
  std::string length_type;  // of a list
  int length_bytes = 0;
};

/// One kind of thing that the body lists: "vertex", "face", ...
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// What the head of a PLY file states.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Text;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  // where the body begins
};

/// Reads the head of a PLY file. Problems: one, whose place has no file: not a PLY head, or not of a readable surface.
Result<PlyHeader> readPlyHeader(std::string_view head);

/// The least number of bytes of a body with these elements.
double minBytes(const PlyHeader& header);

}  // namespace underact::mesh_file
