#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/system/descriptor.h"

namespace underact::system {

/// One thread rings, another waits for it, here or beside others at descriptor(). Ringing takes no lock and never
/// waits; what is rung before anyone waits is heard at once, however often, as one.
class Doorbell {
 public:
  /// Allocates one descriptor; where the system has none left, see descriptor().
  Doorbell();
  /// Any thread, the servo's too.
  void ring() noexcept UNDERACT_REAL_TIME;
  /// false: nobody rang in time_ns.
  bool waitFor(std::int64_t time_ns) noexcept UNDERACT_REAL_TIME;
  /// Readable while it was rung; below 0: the system has none left, and who waits looks again soon.
  int descriptor() const { return file_.number(); }
  /// Forgets what was rung. false: nothing was.
  bool clear() noexcept UNDERACT_REAL_TIME;

 private:
  Descriptor file_;
};

}  // namespace underact::system
