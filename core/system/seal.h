#pragma once
#include <cstdint>

namespace underact::system {

/// From here on this process reads and writes what it has open, takes memory up to so many bytes, computes up to so
/// many seconds, and ends; nothing else: no file, no socket, no process, no thread. By limits and a filter of system
/// calls. false: the system refused a part of it; then the process must look at no
/// file, and end with helper::kNotSealed.
[[nodiscard]] bool seal(std::uint64_t most_bytes, double most_cpu_s);

/// Before seal(): this process ends when the thread ends that started it.
void endWithStarter();

}  // namespace underact::system
