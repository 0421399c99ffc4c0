#pragma once
#include <atomic>
#include <mutex>
#include <thread>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/preset.h"
#include "core/servo/device_port.h"
#include "core/system/clock.h"

namespace underact::test {

/// An arm whose tip stands where it is placed, by nobody's hand: what its motors are told is for whoever looks, also
/// after the port in front of it is gone. Any threads.
class ArmDouble {
 public:
  explicit ArmDouble(const arm::Preset& preset = *arm::findPreset(arm::kDefaultArm)) : preset_(preset) {}
  const arm::Preset& preset() const { return preset_; }

  void placeTip(const Vec3& p_WT) {
    const std::scoped_lock lock(mutex_);
    q_rad_ = arm::solvePosition(preset_.geometry, p_WT).q_rad;
    moved_ns_ = system::monotonicNow_ns();
    answered_ns_ = 0;
  }
  void holdButton(bool held) { button_ = held; }
  void freeze(bool on) { frozen_ = on; }
  /// Each sample is so much later than the one before, whatever the clock says.
  void countTime(std::int64_t period_ns) { period_ns_ = period_ns; }
  /// It gives no sample any more, and says why, until it is opened again.
  void lose(bool lost) { lost_ = lost; }
  /// It does not return from a read.
  void hang(bool hangs) { hangs_ = hangs; }
  /// It cannot be opened.
  void stayLost(bool stays) { stays_lost_ = stays; }

  Vec3 force_N() const {
    const std::scoped_lock lock(mutex_);
    return f_N_;
  }
  /// Forces that were not zero.
  std::int64_t pushes() const { return pushes_; }
  int cuts() const { return cuts_; }
  /// From the first sample of a new place to the first force that says the opposite of the one before, ns; 0: not yet.
  std::int64_t answered_ns() const {
    const std::scoped_lock lock(mutex_);
    return answered_ns_;
  }

  std::string title = "Double";  // before it is opened

  class Port final : public servo::DevicePort {
   public:
    explicit Port(ArmDouble& arm) : arm_(arm), opened_ns_(system::monotonicNow_ns()) { arm_.time_ns_ = 0; }
    ~Port() override { arm_.take(Vec3::Zero()); }
    bool read(arm::Sample& sample) noexcept override {
      while (arm_.hangs_) std::this_thread::yield();
      return arm_.give(sample, opened_ns_);
    }
    void write(const safety::GatedForce& force) noexcept override { arm_.take(force.f_T_W()); }
    void cut() noexcept override {
      ++arm_.cuts_;
      arm_.take(Vec3::Zero());
    }
    Problems reopen() override {
      if (arm_.stays_lost_) return {{"The double is still unplugged.", {}}};
      arm_.lost_ = false;
      return {};
    }
    Sentence fixedRateReason() const override { return {}; }
    Sentence trouble() const override { return arm_.lost_ ? "The double was unplugged. Plug it in." : ""; }
    servo::DeviceInfo info() const override { return {arm_.title, false, true, 0.5}; }

   private:
    ArmDouble& arm_;
    const std::int64_t opened_ns_;
  };

 private:
  bool give(arm::Sample& sample, std::int64_t opened_ns) {
    const std::scoped_lock lock(mutex_);
    if (lost_) return false;
    if (!frozen_) tremble_ = !tremble_;
    sample.q_rad = q_rad_;
    sample.q_rad[3] += tremble_ ? 1e-6 : 0.0;  // of the gimbal: the tip stands still, and the sample does not
    sample.buttons = button_ ? 1U : 0U;
    time_ns_ = period_ns_ > 0 ? time_ns_ + period_ns_ : std::max(system::monotonicNow_ns() - opened_ns, time_ns_ + 1);
    sample.time_ns = time_ns_;
    if (given_ns_ < moved_ns_) {
      given_ns_ = system::monotonicNow_ns();
      f_before_N_ = f_N_;
    }
    return true;
  }
  void take(const Vec3& force_N) {
    const std::scoped_lock lock(mutex_);
    f_N_ = force_N;
    if (force_N != Vec3::Zero()) ++pushes_;
    if (answered_ns_ == 0 && given_ns_ >= moved_ns_ && force_N.dot(f_before_N_) < f_before_N_.squaredNorm() - 1e-6)
      answered_ns_ = system::monotonicNow_ns() - given_ns_;
  }

  const arm::Preset preset_;
  mutable std::mutex mutex_;
  arm::JointAngles q_rad_ = arm::solvePosition(preset_.geometry, Vec3(0.0, 0.0, 0.06)).q_rad;
  Vec3 f_N_ = Vec3::Zero(), f_before_N_ = Vec3::Zero();
  std::int64_t time_ns_ = 0, moved_ns_ = 0, given_ns_ = 0, answered_ns_ = 1;
  bool tremble_ = false;
  std::atomic<std::int64_t> pushes_{0}, period_ns_{0};
  std::atomic<int> cuts_{0};
  std::atomic<bool> button_{false}, frozen_{false}, lost_{false}, hangs_{false}, stays_lost_{false};
};

}  // namespace underact::test
