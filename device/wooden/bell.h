#pragma once
#include <cstdint>

#include "core/base/real_time.h"

#ifdef __linux__
#include <semaphore.h>
#else
#include <atomic>
#endif

namespace underact::device {

/// One thread rings, another waits for it, not for ever. Ringing takes no lock and never waits; what is rung before
/// anyone waits is heard at once, however often, as one.
class Bell {
 public:
  Bell();
  ~Bell();
  Bell(const Bell&) = delete;
  Bell& operator=(const Bell&) = delete;
  void ring() noexcept UNDERACT_REAL_TIME;
  /// false: nobody rang in time_ns.
  bool waitFor(std::int64_t time_ns) noexcept UNDERACT_REAL_TIME;

 private:
#ifdef __linux__
  bool isHeard() noexcept UNDERACT_REAL_TIME;

  sem_t semaphore_;
#else
  std::atomic<bool> rung_{false};
#endif
};

}  // namespace underact::device
