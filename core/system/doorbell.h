#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/system/descriptor.h"

namespace underact::system {

/// One thread rings, another waits for it, alone or together with other descriptors by descriptor(). Ringing takes no
/// lock and never waits; rings before a wait end it at once, and count as one.
class Doorbell {
 public:
  /// Allocates one descriptor; where the system has none left, see descriptor().
  Doorbell();
  /// Any thread, the servo's too.
  void ring() noexcept UNDERACT_REAL_TIME;
  /// Waits for a ring. false: none within time_ns.
  bool waitFor(std::int64_t time_ns) noexcept UNDERACT_REAL_TIME;
  /// Readable while it was rung; below 0: the system had no descriptor left, and the waiting thread has to poll.
  int descriptor() const { return file_.number(); }
  /// Clears the rings. false: there was none.
  bool clear() noexcept UNDERACT_REAL_TIME;

 private:
  Descriptor file_;
};

}  // namespace underact::system
