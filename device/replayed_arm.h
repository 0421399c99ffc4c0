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

/// An arm in front of another one: it hands everything through until a recording is replayed; then its joints are the
/// recorded ones, the other arm gets zero force and is read all the same, and the forces of the servo go nowhere. Its
/// clock goes on evenly through all of it, one period a read; Sample::epoch counts up at each jump.
class ReplayedArm final : public servo::DevicePort {
 public:
  static constexpr double kSlowest = 0.1, kFastest = 4.0;

  /// rate_hz: of the servo, at first.
  ReplayedArm(std::unique_ptr<servo::DevicePort> inner, int rate_hz);

  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME override;
  void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME override;
  void cut() noexcept UNDERACT_REAL_TIME override { inner_->cut(); }
  Problems reopen() override { return inner_->reopen(); }
  servo::LastWord lastWord() const override { return inner_->lastWord(); }
  bool drive(servo::Ticks& ticks, int rate_hz) override { return inner_->drive(ticks, rate_hz); }
  void endDrive() override { inner_->endDrive(); }
  Sentence trouble() const override { return inner_->trouble(); }
  std::vector<std::string> listing() const override { return inner_->listing(); }
  servo::DeviceInfo info() const override;
  Sentence fixedRate() const override;
  Sentence refusesRate(int rate_hz) const override;
  void setRate(int rate_hz) override;

  // One thread, the window's; none of it waits for the servo. What is said is taken up by the next read().
  /// Begins with row 0, paused. Null: the other arm is there again.
  void replay(std::shared_ptr<const Recorded> recorded);
  bool isReplaying() const { return orders_.recorded != nullptr; }
  /// At the end of the recording (or, with a loop, at its end) it begins anew.
  void play();
  void pause();
  /// row: held within the recording. The row after the present one is no jump: what a hand does goes on.
  void seek(std::int64_t row);
  /// Times the recorded speed; held within kSlowest and kFastest. At 1 the samples are the recorded ones to the bit;
  /// else they lie on the line from one row to the next. Where the recording's rate is not the servo's it goes by time.
  void setSpeed(double speed);
  double speed() const { return orders_.speed; }
  /// From the last of these rows it goes on with the first; none: it stops at the end.
  void setLoop(const std::optional<std::pair<std::int64_t, std::int64_t>>& rows);

  /// Where a sample came from.
  struct Place {
    std::int64_t time_ns = 0;  // of the sample
    double row = 0.0;
    bool moves = false;  // the row is another one than that of the read before
  };
  /// Of each replayed sample, in order; 4 s of them are kept while nobody asks.
  bool take(Place& place) { return places_.pop(place); }
  /// As of the last read(), or as it was told since.
  double row() const { return isTaken(sought_number_) ? row_.load() : static_cast<double>(orders_.row); }
  bool isPlaying() const { return isTaken(moved_number_) ? playing_.load() : orders_.plays; }

 private:
  /// All that the window wants, whole each time: the servo thread takes up the latest only.
  struct Orders {
    std::uint64_t number = 0;
    const Recorded* recorded = nullptr;
    std::uint64_t opened = 0;  // counts recordings
    std::uint64_t moved = 0;   // counts plays, pauses and seeks
    bool plays = false;
    std::uint64_t sought = 0;  // counts seeks: each is done once
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
  std::uint64_t moved_number_ = 0, sought_number_ = 0;                           // of the last orders that said so
  std::vector<std::pair<std::uint64_t, std::shared_ptr<const Recorded>>> kept_;  // with the orders that let it go
  mutable std::mutex title_mutex_;  // of what any thread may ask for; never the servo's
  std::string title_;
  // Between them.
  servo::Slot<Orders> slot_;
  std::atomic<std::uint64_t> taken_{0};
  std::atomic<double> row_{0.0};
  std::atomic<bool> playing_{false};
  boost::lockfree::spsc_queue<Place> places_;
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
