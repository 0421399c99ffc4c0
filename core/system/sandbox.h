#pragma once
#include <cstdint>

namespace underact::system {

/// Seals this process off: from here on it can only read and write its open descriptors, allocate up to max_bytes,
/// compute up to max_cpu_s, and end: no file, socket, process or thread. By limits and a filter of system calls.
/// false: the system refused a part of it; then the process must not read any file, and has to end with
/// helper::kNotSealed.
[[nodiscard]] bool enterSandbox(std::uint64_t max_bytes, double max_cpu_s);

/// Ends this process when the thread that started it ends; to be called before enterSandbox().
void endWithParent();

}  // namespace underact::system
