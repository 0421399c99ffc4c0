#pragma once
#include <cstddef>
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

/// Of a file or a pipe, in one go: kernels that do not preempt themselves let nobody run on that processor before a
/// read is done, not even the servo. Of 38 MB at once that was 6 ms.
inline constexpr std::size_t kBlock = std::size_t{1} << 18;

/// A coordinate from here on is no number to us: the square of a distance must be a float.
inline constexpr float kBeyondAll = 1e15F;

}  // namespace underact::mesh_file
