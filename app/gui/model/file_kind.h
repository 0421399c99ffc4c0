#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace underact::gui {

/// The files that the window opens.
enum class FileKind : std::uint8_t { Scene, Session, Arm, Mesh, Curve, Lesson, Figures, Notebook };

/// The kind of a file by its first bytes, up to mesh_file::kHeadBytes; the ending of its name decides only where they
/// do not tell. A file of a kind may still be wrong: whoever reads it says how. Problems: one, what the file is instead
/// and the way out.
Result<FileKind> fileKindOf(std::string_view head, std::uint64_t file_bytes, const std::string& path);

/// The kind of the file at the path, which is opened without waiting. Problems, too: it is no regular file, or cannot
/// be read.
Result<FileKind> kindOfFile(const std::string& path);

}  // namespace underact::gui
