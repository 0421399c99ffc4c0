#pragma once
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "core/servo/device_port.h"
#include "core/servo/slot.h"
#include "device/recorded.h"

namespace underact::device {

/// An arm in front of another one: it passes everything through until a recording is replayed; then its joints are the
/// recorded ones, the other arm is still read but gets zero force, and the servo's forces are discarded. Its clock
/// advances evenly throughout, one period per read; Sample::epoch counts up at each jump.
class ReplayedArm final : public servo::DevicePort {
 public:
  static constexpr double kSlowest = 0.1, kFastest = 4.0;

  /// rate_hz: of the servo, at first.
  ReplayedArm(std::unique_ptr<servo::DevicePort> inner, int rate_hz);

  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME override;
  void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME override;
  void cut() noexcept UNDERACT_REAL_TIME override { inner_->cut(); }
  Problems reopen() override { return inner_->reopen(); }
  servo::ZeroForceMessage zeroForceMessage() const override { return inner_->zeroForceMessage(); }
  bool drive(servo::Ticks& ticks, int rate_hz) override { return inner_->drive(ticks, rate_hz); }
  void endDrive() override { inner_->endDrive(); }
  Sentence trouble() const override { return inner_->trouble(); }
  std::vector<std::string> listing() const override { return inner_->listing(); }
  servo::DeviceInfo info() const override;
  Sentence fixedRateReason() const override;
  Sentence rateRefusal(int rate_hz) const override;
  void setRate(int rate_hz) override;

  // One thread, the window's; nothing waits for the servo. Orders take effect at the next read().
  /// Begins with row 0, paused. Null: back to the other arm.
  void replay(std::shared_ptr<const Recorded> recorded);
  bool isReplaying() const { return orders_.recorded != nullptr; }
  /// At the end of the recording, or of the loop, it begins again.
  void play();
  void pause();
  /// row: clamped to the recording. The row after the present one is not a jump: the hand's motion continues.
  void seek(std::int64_t row);
  /// A factor of the recorded speed, clamped to kSlowest and kFastest. At 1 the samples are bit-identical to the
  /// recorded ones; otherwise they are interpolated linearly between rows. Where the recording's rate is not the
  /// servo's it goes by time.
  void setSpeed(double speed);
  double speed() const { return orders_.speed; }
  /// After the last of these rows the first follows; none: it stops at the end.
  void setLoop(const std::optional<std::pair<std::int64_t, std::int64_t>>& rows);

  /// The origin of a sample.
  struct SampleOrigin {
    std::int64_t time_ns = 0;  // of the sample
    double row = 0.0;
    bool moves = false;  // the row differs from that of the read before
  };
  /// Each replayed sample, in order; 4 s of them are kept until asked for.
  bool take(SampleOrigin& place) { return places_.pop(place); }
  /// As of the last read() or the last order.
  double row() const { return isTaken(sought_number_) ? row_.load() : static_cast<double>(orders_.row); }
  bool isPlaying() const { return isTaken(moved_number_) ? playing_.load() : orders_.plays; }

 private:
  /// All that the window asks for, complete each time: the servo thread takes only the latest.
  struct Orders {
    std::uint64_t number = 0;
    const Recorded* recorded = nullptr;
    std::uint64_t opened = 0;  // counts recordings
    std::uint64_t moved = 0;   // counts plays, pauses and seeks
    bool plays = false;
    std::uint64_t sought = 0;  // counts seeks, to do each once
    std::int64_t row = 0;
    double speed = 1.0;
    std::int64_t loop_from = 0, loop_to = -1;
  };
  bool isTaken(std::uint64_t number) const { return taken_.load(std::memory_order_acquire) >= number; }
  void send();
  bool takeUp(const Orders& orders) noexcept UNDERACT_REAL_TIME;
  void seekTo(std::int64_t row) noexcept UNDERACT_REAL_TIME;
  void handThrough(bool has_sample, const arm::Sample& own, arm::Sample& sample) noexcept UNDERACT_REAL_TIME;
  void advance() noexcept UNDERACT_REAL_TIME;
  void jumpTo(std::int64_t row) noexcept UNDERACT_REAL_TIME;
  void goOn(double step) noexcept UNDERACT_REAL_TIME;
  arm::JointAngles joints() const noexcept UNDERACT_REAL_TIME;
  void tell(std::int64_t time_ns, bool moves) noexcept UNDERACT_REAL_TIME;

  std::unique_ptr<servo::DevicePort> inner_;
  int rate_hz_;
  std::int64_t period_ns_;

  // The window's thread.
  Orders orders_;
  std::uint64_t moved_number_ = 0, sought_number_ = 0;  // of the last orders that contained one
  std::vector<std::pair<std::uint64_t, std::shared_ptr<const Recorded>>> kept_;  // with the orders that release it
  mutable std::mutex title_mutex_;  // for what any thread may ask for; never the servo's
  std::string title_;
  // Between them.
  servo::Slot<Orders> slot_;
  std::atomic<std::uint64_t> taken_{0};
  std::atomic<double> row_{0.0};
  std::atomic<bool> playing_{false};
  boost::lockfree::spsc_queue<SampleOrigin> places_;
  // The servo's thread.
  Orders now_;
  double at_ = 0.0;  // row
  bool plays_ = false;
  std::int64_t time_ns_ = 0;   // of the last sample
  std::int64_t ahead_ns_ = 0;  // of the other arm's clock
  bool is_back_ = false;       // the other arm's next sample is the first after a replay
  std::uint32_t epoch_ = 0, inner_epoch_ = 0;
};

}  // namespace underact::device
