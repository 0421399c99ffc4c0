#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace underact::mesh_file {

/// What a mesh is written as.
enum class Format : std::uint8_t { StlBinary, StlText, Obj, Ply, Off };

inline constexpr int kFormats = 5;

/// The word that the reading program takes: "stl-binary", "stl-text", "obj", "ply", "off".
const char* wordOf(Format format);

/// What people call it: "binary STL", ...
const char* nameOf(Format format);

/// By what the file holds, and by its name where that does not tell (OBJ begins with anything). head: its first bytes,
/// up to kHeadBytes. A binary STL is known by its size, since many begin with "solid", too. Problems: it is none of
/// these.
Result<Format> formatOf(std::string_view head, std::uint64_t file_bytes, const std::string& path);

inline constexpr std::size_t kHeadBytes = 64 << 10;

/// Cheap: what the head states, beside the size of the file. Problems: it states more than the file can hold, or
/// nothing that could be a surface.
Problems checkHead(Format format, std::string_view head, std::uint64_t file_bytes, const std::string& path);

}  // namespace underact::mesh_file
