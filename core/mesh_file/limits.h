#pragma once
#include <cstdint>

namespace underact::mesh_file {

/// More than 2^27 faces, which is what a surface takes, in the densest format.
inline constexpr std::uint64_t kMostFileBytes = std::uint64_t{4} << 30;

/// What the reading program may have in memory, for a file of that size: the file, what is read of it and what OpenMesh
/// keeps meanwhile, none of which is more than some bytes for each byte of the file.
inline constexpr std::uint64_t mostMemory(std::uint64_t file_bytes) {
  return (std::uint64_t{96} << 20) + 24 * file_bytes;
}

/// How long it may compute, s. Measured: 0.1 s a MiB for the slowest format, OBJ.
inline constexpr double mostCpu_s(std::uint64_t file_bytes) {
  return 0.8 + 1.0 * static_cast<double>(file_bytes) / (1 << 20);
}

/// And how long it may take, on a busy machine and a slow disk.
inline constexpr double mostTime_s(std::uint64_t file_bytes) {
  return 10.0 * mostCpu_s(file_bytes);
}

/// A coordinate from here on is no number to us: the square of a distance must be a float.
inline constexpr float kBeyondAll = 1e15F;

}  // namespace underact::mesh_file
