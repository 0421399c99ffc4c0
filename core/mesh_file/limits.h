#pragma once
#include <cstddef>
#include <cstdint>

namespace underact::mesh_file {

/// More than 2^27 faces, which is what a surface takes, in the densest format.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30;

/// The memory limit of the reader, for a file of that size: the file, its contents and what OpenMesh keeps meanwhile
/// are each no more than some bytes for each byte of the file.
inline constexpr std::uint64_t maxMemory(std::uint64_t file_bytes) {
  return (std::uint64_t{96} << 20) + 24 * file_bytes;
}

/// The reader's limit of processor time, s. Measured: 0.1 s a MiB for the slowest format, OBJ.
inline constexpr double maxCpu_s(std::uint64_t file_bytes) {
  return 0.8 + 1.0 * static_cast<double>(file_bytes) / (1 << 20);
}

/// The reader's time limit, s, on a busy machine and a slow disk.
inline constexpr double maxTime_s(std::uint64_t file_bytes) {
  return 10.0 * maxCpu_s(file_bytes);
}

/// Bytes read at once from a file or a pipe: a kernel without preemption lets nothing else run on that processor before
/// a read is done, not even the servo. For 38 MB at once that was 6 ms.
inline constexpr std::size_t kBlock = std::size_t{1} << 18;

/// Coordinates from here on count as not finite: the square of a distance must fit into a float.
inline constexpr float kBeyondAll = 1e15F;

}  // namespace underact::mesh_file
