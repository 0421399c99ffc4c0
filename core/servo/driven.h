#pragma once
#include <cstdint>
#include <memory>

#include "core/servo/loop.h"

namespace underact::servo {

/// Ticks a loop from an arm's own clock (see DevicePort::drive()), in the place of the servo's thread. What is late is
/// measured against a period after the tick before: the arm's deadlines are its own.
class Driven final : public Ticks {
 public:
  /// Null where the arm has no clock of its own.
  static std::unique_ptr<Driven> start(Loop& loop, DevicePort& device, int rate_hz);
  ~Driven();  // the last tick is done, and zero force written
  Driven(const Driven&) = delete;
  Driven& operator=(const Driven&) = delete;

  void tick() noexcept UNDERACT_REAL_TIME override;

 private:
  Driven(Loop& loop, DevicePort& device, int rate_hz);
  Loop& loop_;
  DevicePort& device_;
  std::int64_t period_ns_;
  std::int64_t before_ns_ = 0;  // when the last tick began
};

}  // namespace underact::servo
