#pragma once
#include "core/mesh_file/input.h"
#include "core/mesh_file/raw.h"

namespace underact::mesh_file {

/// The sentence of a problem where the call was cancelled.
inline constexpr const char* kCancelled = "Cancelled.";

/// Reads a mesh in a separate process, underact-mesh-reader, which is sealed off from everything else: whatever the
/// file does to the reader stays there. Bounded by limits.h in memory and time. Problems: one, with the file; also
/// where the reader was not found (UNDERACT_MESH_READER says where it is), crashed, took too long, or was cancelled.
Result<RawMesh> readFile(const Input& input, const TaskMonitor& monitor = {});
Result<RawMesh> readFile(const std::string& path, const TaskMonitor& monitor = {});

}  // namespace underact::mesh_file
