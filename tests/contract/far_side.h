#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/servo/device_port.h"

namespace underact::test {

/// What stands behind a driver: the arm itself, or what speaks as it does, at the border where the hardware would be.
/// All that is asked of it is as seen there, beyond the driver. Its tip rests at (0, 0, 0.06) m and is moved by nobody,
/// unless it says that it moves.
class FarSide {
 public:
  virtual ~FarSide() = default;
  /// The driver, open to this arm; only one at a time.
  virtual Result<std::unique_ptr<servo::DevicePort>> open() = 0;

  /// The force that the motors have now, N, in the frame W of the arm: of what came last, or zero where a watchdog of
  /// the arm's own has ended it.
  virtual Vec3 force_N() const = 0;
  /// How many forces came, zero or not.
  virtual std::int64_t forces() const = 0;
  /// How many more may come of what lay unread beyond the cable when it was pulled, on a machine too busy to read it.
  virtual std::int64_t unreadForces() const { return 0; }

  virtual void placeTip(const Vec3& p_WT) = 0;
  virtual void holdButton(bool held) = 0;
  /// false: an arm that has none; holdButton() does nothing then.
  virtual bool hasButton() const { return true; }
  /// false: an arm that nobody can unplug.
  virtual bool hasCable() const { return true; }
  /// The cable is pulled, the other end is gone, the driver's library reports a lost device.
  virtual void unplug() {}
  virtual void plugIn() {}
  /// It goes on answering, with the last sample.
  virtual void freeze(bool /*on*/) {}
  /// What the arm's side does by itself when no force comes for long: seconds until its motors are off; 0: never.
  virtual double ownWatchdog_s() const { return 0.0; }
  /// How far the tip may be from where it was placed: steps of encoders, m.
  virtual double resolution_m() const { return 1e-4; }
  /// How far the force at the motors may be from the one that was written: steps of currents, N.
  virtual double forceResolution_N() const { return 1e-6; }
  /// Joints that stay the same to the bit let the force go (DeviceInfo::frozen_s); false: this arm may stand still.
  virtual bool mustMove() const { return true; }
};

/// A driver that must keep the contract. make: null where this machine cannot run it; then why says so.
struct Driver {
  std::string name;
  std::unique_ptr<FarSide> (*make)(std::string& why);
};

/// All of them; tests/contract/drivers.cpp.
std::vector<Driver> drivers();

}  // namespace underact::test
