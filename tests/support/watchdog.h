#pragma once
#include <unistd.h>

namespace underact::test {

/// Ends the program where a test hangs: a failure that is seen, in place of a day that is lost.
class Watchdog {
 public:
  explicit Watchdog(unsigned seconds = 20) { ::alarm(seconds); }
  ~Watchdog() { ::alarm(0); }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
};

}  // namespace underact::test
