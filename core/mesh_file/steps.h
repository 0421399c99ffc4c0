#pragma once
#include <algorithm>
#include <cstdint>

#include "core/base/task_monitor.h"

namespace underact::mesh_file {

/// Checks a watch now and then within a loop, so that the check costs nothing.
class Steps {
 public:
  /// watch: outlives this.
  explicit Steps(const TaskMonitor& monitor) : watch_(monitor) {}
  /// Whether to stop; to be called once an iteration.
  bool isCancelled() {
    if ((++count_ & 0x3FFFU) == 0) is_cancelled_ = is_cancelled_ || watch_.isCancelled();
    return is_cancelled_;
  }

 private:
  const TaskMonitor& watch_;
  std::uint32_t count_ = 0;
  bool is_cancelled_ = false;
};

/// A watch for a part of the work, whose progress is that from `from` to `to` of the whole.
inline TaskMonitor partOf(const TaskMonitor& monitor, double from, double to) {
  TaskMonitor part;
  part.cancelled = monitor.cancelled;
  if (monitor.progress) {
    part.progress = [&monitor, from, to](const char* step, double share) {
      monitor.report(step, from + (to - from) * std::clamp(share, 0.0, 1.0));
    };
  }
  return part;
}

}  // namespace underact::mesh_file
