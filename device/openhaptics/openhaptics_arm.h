#pragma once
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/arm/preset.h"
#include "core/servo/device_port.h"
#include "device/driver.h"
#include "device/openhaptics/capabilities.h"
#include "device/openhaptics/frames.h"

namespace underact::device::openhaptics {

/// An Omni, Touch or Touch X behind the vendor's driver, whose scheduler is the clock. It runs from opening to closing,
/// with zero force while the servo is stopped. Never tried on an arm.
class OpenHapticsArm final : public servo::DevicePort {
 public:
  struct Options {
    arm::Preset arm;  // whose lengths the tip is compared with, and whose force is the limit where the driver has none
    int rate_hz = 1000;
    std::string address;  // the driver's name of it; empty: the usual names
  };
  /// Problems: no driver, no arm, no such rate; with the way out.
  static Result<std::unique_ptr<OpenHapticsArm>> open(const Options& options);
  ~OpenHapticsArm() override;

  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME override;
  void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME override;
  /// Takes effect in the next frame. If the driver's scheduler has stopped, nothing in this process can.
  void cut() noexcept UNDERACT_REAL_TIME override;
  Problems reopen() override;
  Sentence fixedRateReason() const override;
  Sentence rateRefusal(int rate_hz) const override;
  void setRate(int rate_hz) override;
  bool drive(servo::Ticks& ticks, int rate_hz) override;
  void endDrive() override;
  Sentence trouble() const override;
  servo::DeviceInfo info() const override;
  std::vector<std::string> listing() const override;
  /// Force errors since it was made.
  std::int64_t forceErrors() const { return frames_->armStatus().forceErrors(); }

 private:
  OpenHapticsArm(const Calls& hd, const Options& options);
  Problems connect();
  Problems initialise();
  Problems awaitFirstFrame();
  void disconnect();
  void say(const Problems& problems);

  const Calls& hd_;
  const Options options_;
  std::unique_ptr<Frames> frames_;
  Handle device_ = kNoHandle;
  Scheduled scheduled_ = 0;
  bool is_open_ = false;
  bool hangs_ = false;  // a frame has not returned from the driver
  int rate_hz_;

  mutable std::mutex mutex_;  // for what follows; never in the tick
  Sentence trouble_;
  Capabilities capabilities_;
};

/// For the catalogue.
Result<std::unique_ptr<servo::DevicePort>> openArm(const Request& request);
std::vector<Found> searchArms();

}  // namespace underact::device::openhaptics
