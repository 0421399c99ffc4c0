#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/servo/device_port.h"
#include "core/servo/slot.h"
#include "core/system/doorbell.h"
#include "device/wooden_haptics/handshake.h"
#include "device/wooden_haptics/kinematics.h"

namespace underact::device {

/// A WoodenHaptics arm over HID. One thread reads the arm's reports, another sends it currents; the tick takes the
/// newest report and leaves the newest force. If no new report is there, the tick waits up to half a period for one;
/// then the last one is used while it is no older than kStale_ns (or kStalePeriods). If no force was written for
/// kQuietPeriods, the arm is sent zero.
class WoodenArm final : public servo::DevicePort {
 public:
  static constexpr std::int64_t kStale_ns = 10'000'000;
  static constexpr int kStalePeriods = 5, kQuietPeriods = 5;

  /// arm: the arm whose joints the samples have. Its own ("woodenhaptics"): as measured. Another arm: the joints that
  /// put that arm's tip where the tip is, joints 4 to 6 at 0; out of that arm's reach no force goes out. Problems: none
  /// is plugged in; it may not be opened; it sends nothing; its kinematics are not published.
  static Result<std::unique_ptr<WoodenArm>> open(HidBus& bus, const WoodenChoice& choice, const arm::Geometry& arm,
                                                 int rate_hz);
  ~WoodenArm() override;

  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME override;
  void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME override;
  void cut() noexcept UNDERACT_REAL_TIME override;
  Problems reopen() override;
  Sentence fixedRateReason() const override { return {}; }
  void setRate(int rate_hz) override;
  servo::ZeroForceMessage zeroForceMessage() const override;
  Sentence trouble() const override;
  servo::DeviceInfo info() const override;

 private:
  enum class Loss : std::uint8_t { None, Reading, Writing };
  /// A report as it was received.
  struct Taken {
    std::uint64_t number = 0;
    std::int64_t time_ns = 0;
    std::array<int, 3> counts{};
    bool button = false;
    std::uint32_t epoch = 0;
  };
  struct Wanted {
    std::uint64_t number = 0;
    Currents_mA currents_mA{};
  };
  WoodenArm(HidBus& bus, WoodenChoice choice, const arm::Geometry& arm, int rate_hz);
  Problems connect();
  void start(std::thread& thread, const char* name, void (WoodenArm::*work)());
  void disconnect();
  void lose(Loss loss);
  void readAll();
  void take(const WoodenReport& report);
  void writeAll();
  std::int64_t staleAfter_ns() const noexcept;
  bool isSilent() const;

  HidBus& bus_;
  const WoodenChoice choice_;
  const arm::Geometry arm_;
  std::atomic<std::int64_t> period_ns_;
  // Of the connection; no thread runs while they change.
  std::unique_ptr<HidPipe> pipe_;
  WoodenFormat format_;
  const WoodenModel* model_ = nullptr;
  const WoodenWiring* wiring_ = nullptr;
  bool is_own_ = false;  // the samples are of the arm's own joints
  std::thread reader_, writer_;
  mutable std::mutex words_mutex_;  // never in the tick
  servo::DeviceInfo info_{"WoodenHaptics"};
  Sentence home_path_;
  // Between threads.
  servo::Slot<Taken> taken_;
  servo::Slot<Wanted> wanted_;
  system::Doorbell came_, wrote_;
  std::atomic<bool> ends_{false}, is_cut_{false};
  std::atomic<bool> is_lost_{false};     // its counts mean nothing until it is calibrated
  std::atomic<bool> calibrates_{false};  // it has asked to be calibrated
  std::atomic<Loss> loss_{Loss::None};
  std::atomic<std::int64_t> came_ns_{0};  // the newest report
  std::atomic<int> missed_{0};            // reads in a row that had none
  // The reader's.
  std::uint64_t reports_ = 0;
  std::uint32_t epoch_ = 0;
  // The tick's.
  std::int64_t opened_ns_ = 0;
  std::int64_t time_ns_ = 0;  // of the last sample
  std::uint64_t writes_ = 0;
  arm::JointAngles q_rad_{};  // of the arm itself
  bool is_reached_ = false;
};

}  // namespace underact::device
