#pragma once
#include "core/base/real_time.h"

namespace underact::device::remote {

/// Wakes a thread that waits for the network. Ringing takes no lock and never waits; what is rung before anyone waits
/// is heard at once, however often, as one.
class Doorbell {
 public:
  Doorbell();
  ~Doorbell();
  Doorbell(const Doorbell&) = delete;
  Doorbell& operator=(const Doorbell&) = delete;
  void ring() noexcept UNDERACT_REAL_TIME;
  /// Readable while it was rung; below 0: this system has none, and who waits looks again soon.
  int fd() const { return fd_; }
  void clear();

 private:
  int fd_ = -1;
};

}  // namespace underact::device::remote
