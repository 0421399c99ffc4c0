#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace underact::mesh_file {

/// The format of a mesh file.
enum class Format : std::uint8_t { StlBinary, StlText, Obj, Ply, Off };

inline constexpr int kFormats = 5;

/// The word for it in the arguments of the reader: "stl-binary", "stl-text", "obj", "ply", "off".
const char* wordOf(Format format);

/// The name for users: "binary STL", ...
const char* nameOf(Format format);

/// The format by content, and by name where the content does not tell (OBJ begins with anything). head: its first
/// bytes, up to kHeadBytes. A binary STL is recognised by its size, since many begin with "solid", too. Problems: none
/// of these formats.
Result<Format> formatOf(std::string_view head, std::uint64_t file_bytes, const std::string& path);

inline constexpr std::size_t kHeadBytes = 64 << 10;

/// Compares what the head states with the size of the file; cheap. Problems: it states more than the file can hold, or
/// no surface.
Problems checkHead(Format format, std::string_view head, std::uint64_t file_bytes, const std::string& path);

}  // namespace underact::mesh_file
