#pragma once
#include "core/mesh_file/input.h"
#include "core/mesh_file/raw.h"

namespace underact::mesh_file {

/// Of Problems, where somebody asked for the end.
inline constexpr const char* kCancelled = "Cancelled.";

/// Reads a mesh in a process of its own, underact-mesh-reader, which is shut off from all else: whatever the file does
/// to the reader, it ends there. Bounded by limits.h in memory and time. Problems: one, with the file; also where the
/// reader was not found (UNDERACT_MESH_READER says where it is), crashed, took too long, or was cancelled.
Result<Raw> readFile(const Input& input, const Watch& watch = {});
Result<Raw> readFile(const std::string& path, const Watch& watch = {});

}  // namespace underact::mesh_file
