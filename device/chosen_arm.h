#pragma once
#include <memory>

#include "core/servo/device_port.h"

namespace underact::device {

/// The chosen arm: another one can replace it while the servo is not running. The first arm is kept, and returns when
/// no other is chosen. The clock continues without running back, and Sample::epoch counts up at each exchange.
class ChosenArm final : public servo::DevicePort {
 public:
  explicit ChosenArm(std::unique_ptr<servo::DevicePort> first);

  /// The next reopen() (servo::Host::restart()) puts this open arm in place and closes the one before it. Null: the
  /// first one. The thread that owns the host.
  void choose(std::unique_ptr<servo::DevicePort> arm);
  /// No other arm was chosen, or the first one is about to return.
  bool isFirst() const { return is_chosen_ ? next_ == nullptr : other_ == nullptr; }

  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME override;
  void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME override { arm_->write(force); }
  bool truth(servo::Truth& truth) const noexcept UNDERACT_REAL_TIME override { return arm_->truth(truth); }
  void cut() noexcept UNDERACT_REAL_TIME override { arm_->cut(); }
  Problems reopen() override;
  Sentence fixedRateReason() const override { return arm_->fixedRateReason(); }
  Sentence rateRefusal(int rate_hz) const override { return arm_->rateRefusal(rate_hz); }
  void setRate(int rate_hz) override;
  servo::ZeroForceMessage zeroForceMessage() const override { return arm_->zeroForceMessage(); }
  bool drive(servo::Ticks& ticks, int rate_hz) override { return arm_->drive(ticks, rate_hz); }
  void endDrive() override { arm_->endDrive(); }
  Sentence trouble() const override { return arm_->trouble(); }
  std::vector<std::string> listing() const override { return arm_->listing(); }
  servo::DeviceInfo info() const override { return arm_->info(); }

 private:
  std::unique_ptr<servo::DevicePort> first_, other_, next_;
  servo::DevicePort* arm_;  // one of the first two
  bool is_chosen_ = false;  // next_ takes effect at the next reopen()
  // The servo's thread, or the host's while the servo does not run.
  bool is_new_ = false;        // the next sample is the arm's first
  std::int64_t time_ns_ = 0;   // of the last sample
  std::int64_t ahead_ns_ = 0;  // of the arm's own clock
  std::uint32_t epoch_ = 0, own_epoch_ = 0;
};

}  // namespace underact::device
