#pragma once
#include <cstdint>

namespace underact::mesh_reader {

/// From here on this process reads and writes what it has open, takes memory up to so many bytes, computes up to so
/// many seconds, and ends; nothing else: no file, no socket, no process, no thread. On Linux, by limits and a filter of
/// system calls; elsewhere by limits alone. false: the system refused a part of it.
bool seal(std::uint64_t most_bytes, double most_cpu_s);

}  // namespace underact::mesh_reader
