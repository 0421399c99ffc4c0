#pragma once
#include <cstdint>
#include <string>

#include "core/arm/sample.h"
#include "core/base/real_time.h"
#include "core/safety/gate.h"

namespace underact::servo {

/// What the window says of a device.
struct DeviceInfo {
  std::string title;  // "Simulated arm"
  bool simulated = false;
  bool untested = false;  // never tried on the hardware it is for
};

/// An arm. Constructed open, destroyed closed, both outside the servo thread.
class DevicePort {
 public:
  virtual ~DevicePort() = default;
  /// The newest sample. false: none came in time; then zero is written.
  virtual bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME = 0;
  virtual void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME = 0;
  /// Any thread.
  virtual DeviceInfo info() const = 0;
};

}  // namespace underact::servo
