#pragma once
#include <algorithm>
#include <cstdint>

#include "core/base/watch.h"

namespace underact::mesh_file {

/// Looks at the watch now and then within a loop, so that asking costs nothing.
class Steps {
 public:
  /// watch: outlives this.
  explicit Steps(const Watch& watch) : watch_(watch) {}
  /// true: give up.
  bool isCancelled() {
    if ((++count_ & 0x3FFFU) == 0) is_cancelled_ = is_cancelled_ || watch_.isCancelled();
    return is_cancelled_;
  }

 private:
  const Watch& watch_;
  std::uint32_t count_ = 0;
  bool is_cancelled_ = false;
};

/// A part of a work as a work of its own, whose shares are those of the part.
inline Watch partOf(const Watch& watch, double from, double to) {
  Watch part;
  part.cancelled = watch.cancelled;
  if (watch.progress) {
    part.progress = [&watch, from, to](const char* step, double share) {
      watch.tell(step, from + (to - from) * std::clamp(share, 0.0, 1.0));
    };
  }
  return part;
}

}  // namespace underact::mesh_file
