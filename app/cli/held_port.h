#pragma once
#include <atomic>
#include <memory>
#include <utility>

#include "core/servo/device_port.h"

namespace underact::cli {

/// A port that keeps the servo thread waiting in its first read() until letGo(): commands sent before are then taken up
/// in the same tick in which the arm is read for the first time, however the threads happen to run. That makes a run in
/// real time give the numbers of one at full speed.
class HeldPort final : public servo::DevicePort {
 public:
  explicit HeldPort(std::unique_ptr<servo::DevicePort> port) : port_(std::move(port)) {}

  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME override {
    if (to_skip_ == 0) return port_->read(sample);
    released_.wait(false);
    --to_skip_;
    return false;
  }
  void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME override { port_->write(force); }
  servo::DeviceInfo info() const override { return port_->info(); }

  /// From then on the arm is read. Another thread than the servo's.
  void letGo() {
    released_ = true;
    released_.notify_all();
  }

 private:
  std::unique_ptr<servo::DevicePort> port_;
  std::atomic<bool> released_{false};
  int to_skip_ = 2;  // the read that waited, and the next, whose tick is late for it
};

}  // namespace underact::cli
