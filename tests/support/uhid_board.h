#pragma once
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "tests/support/wooden_firmware.h"

namespace underact::test {

/// A board at the kernel's border: through /dev/uhid the kernel sees a HID device with an interrupt endpoint each way,
/// makes a hidraw node of it, and what is written there comes here.
class UhidBoard {
 public:
  /// Not plugged in yet. The firmware outlives it.
  explicit UhidBoard(WoodenFirmware& firmware);
  ~UhidBoard();
  UhidBoard(const UhidBoard&) = delete;
  UhidBoard& operator=(const UhidBoard&) = delete;

  /// false: there is no /dev/uhid here, or this user may not use it.
  static bool isPossible();
  /// Returns when the node is there, or after some seconds.
  void plugIn();
  /// Returns when the node is gone.
  void unplug();
  /// "/dev/hidraw0"; empty: none is there.
  std::string node() const;

 private:
  void run();
  void create() const;
  void say() const;
  void hear();

  WoodenFirmware& firmware_;
  int fd_ = -1;
  std::int64_t next_ns_ = 0;  // when it may say something again
  bool is_asked_ = false;     // the thread's, as the line above
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace underact::test
