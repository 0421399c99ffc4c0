#pragma once
#include <algorithm>
#include <atomic>

#include "device/simulated_arm.h"

namespace underact::test {

/// A simulated arm whose cable can be pulled. Its motors' greatest force is for whoever looks.
class LooseCable final : public servo::DevicePort {
 public:
  LooseCable(const device::SimulatedArm::Options& options, std::atomic<bool>& plugged_in)
      : arm_(options), plugged_in_(plugged_in) {}
  bool read(arm::Sample& sample) noexcept override { return arm_.read(sample) && plugged_in_.load(); }
  void write(const safety::GatedForce& force) noexcept override {
    max_N_ = std::max(max_N_.load(), force.f_T_W().norm());
    arm_.write(force);
  }
  void cut() noexcept override { arm_.cut(); }
  Problems reopen() override {
    if (plugged_in_.load()) return {};
    return {{"No arm answers on the cable.", {}}};
  }
  Sentence fixedRateReason() const override { return {}; }
  servo::DeviceInfo info() const override { return {"Arm on a loose cable", false, true}; }

  device::SimulatedArm& arm() { return arm_; }
  /// Since the last call, N.
  double takeMax_N() { return max_N_.exchange(0.0); }

 private:
  device::SimulatedArm arm_;
  std::atomic<bool>& plugged_in_;
  std::atomic<double> max_N_{0.0};
};

}  // namespace underact::test
