#pragma once
#include <atomic>
#include <cstdint>

#include "core/arm/preset.h"
#include "core/servo/device_port.h"
#include "device/openhaptics/abi.h"
#include "device/openhaptics/arm_status.h"
#include "device/openhaptics/calibration.h"
#include "device/openhaptics/capabilities.h"
#include "device/openhaptics/errors.h"
#include "device/openhaptics/exchange.h"

namespace underact::device::openhaptics {

class Frames;

/// What the library's scheduler gets instead of the frames themselves: it may call once too often, and a ticket is
/// never freed.
struct Ticket {
  std::atomic<Frames*> frames{nullptr};  // null: returned
  std::atomic<bool> is_at_work{false};
};

/// What the library's scheduler calls once per period: a frame. It reads the arm, ticks the servo, sends the force. All
/// that it touches is in here, so that a call that never returns holds nothing else.
class Frames {
 public:
  Frames(const Calls& hd, const arm::Preset& arm);

  /// For the scheduler; ticket: a Ticket.
  static std::uint32_t callback(void* ticket);

  // The thread that owns the arm.
  /// Resets for another opening, before it is scheduled.
  Ticket* begin(Handle device);
  /// The servo's tick is called in each frame from now on; null: no more, and none is running when it returns.
  void attach(servo::Ticks* ticks) noexcept;
  /// From the next frame on the force is zero, whatever is written. Waits for such a frame, 0.1 s at most.
  void close() noexcept;
  /// The ticket becomes void. Waits for a running frame, 1 s at most. false: it has not returned.
  bool retire() noexcept;
  /// Frames begun.
  std::int64_t count() const noexcept { return count_.load(std::memory_order_acquire); }
  /// When the last one began.
  std::int64_t began_ns() const noexcept { return began_ns_.load(std::memory_order_relaxed); }
  /// Null until the first frame has ended.
  const Capabilities* capabilities() const noexcept {
    return known_.load(std::memory_order_acquire) ? &capabilities_ : nullptr;
  }

  Exchange& exchange() noexcept { return exchange_; }
  ArmStatus& armStatus() noexcept { return arm_status_; }
  const ArmStatus& armStatus() const noexcept { return arm_status_; }

 private:
  void run() noexcept;
  struct Seen {
    arm::Sample sample;
    std::uint32_t pressed = 0;
    bool is_fresh = false;
    double off_m = 0.0;  // distance of the arm's own tip position from the model's
  };
  void frame() noexcept;
  void learn() noexcept;
  Seen poll(std::int64_t now_ns) noexcept;
  /// The force to send in this frame; zero for any reason there is.
  Vec3 force(const Seen& seen, std::int64_t now_ns) noexcept;
  bool isForceAllowed(std::int64_t now_ns) const noexcept;
  void watchCalibration(bool pressed) noexcept;
  void watchInkwell() noexcept;
  void watchDeviation(double off_m) noexcept;
  void judge(const Drained& drained, bool of_sample, std::int64_t now_ns) noexcept;
  void send(const Vec3& f_T_W) noexcept;
  /// Where the driver answers forces with errors, zero is commanded in a second way: by its switch.
  void switchOutput(bool on) noexcept;
  void rest() noexcept;
  void tick() noexcept;

  const Calls& hd_;
  const arm::Geometry geometry_;
  const double preset_force_N_;
  Exchange exchange_;
  ArmStatus arm_status_;

  Ticket* ticket_ = nullptr;
  std::atomic<servo::Ticks*> ticks_{nullptr};
  std::atomic<bool> is_ticking_{false}, closes_{false}, known_{false};
  std::atomic<std::int64_t> count_{0}, began_ns_{0}, zeros_{0};  // zeros: frames of zero force since close()

  // The scheduler's thread, once begun.
  Handle device_ = kNoHandle;
  Capabilities capabilities_;
  double cap_N_ = 0.0;
  Calibration calibration_;
  std::int64_t opened_ns_ = 0, last_ns_ = 0, quiet_until_ns_ = 0;
  std::uint32_t epoch_ = 0;
  bool is_output_on_ = true;
  bool could_push_ = false;     // in the frame before
  bool inkwell_works_ = false;  // its switch has shown a stylus outside the inkwell
  bool is_docked_ = false;
  bool is_wrong_arm_ = false;
  int off_frames_ = 0;  // in a row on the other side of the limit
  int without_sample_ = 0;
  std::atomic<int> farewells_{0};  // frames of zero force that a stopped arm still gets
};

}  // namespace underact::device::openhaptics
