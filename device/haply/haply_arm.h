#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/arm/preset.h"
#include "core/servo/device_port.h"
#include "core/servo/slot.h"
#include "core/system/doorbell.h"
#include "device/haply/line.h"
#include "device/haply/messages.h"

namespace underact::device::haply {

/// An Inverse3 behind Haply's service. A thread keeps the connection: it sends each new force in a frame of its own,
/// which the service answers with the state; the tick takes the newest one. If no new one is there, the tick waits up
/// to half a period for it; then the last one is used while it is no older than kStale_ns (or kStalePeriods). If no
/// force was written for kQuietPeriods, the service is told zero, and so asked for the state. Of frames that push, no
/// more than kMaxUnanswered are under way. A lost connection stays lost until reopen().
class HaplyArm final : public servo::DevicePort {
 public:
  static constexpr std::int64_t kStale_ns = 20'000'000;
  static constexpr int kStalePeriods = 5, kQuietPeriods = 5, kMaxUnanswered = 4;

  /// arm: the arm whose joints the samples have: those that put its tip where the Inverse3's cursor is, and its stylus
  /// as the grip, or joints 4 to 6 at 0 without one. Out of that arm's reach no force goes out. Problems: no service
  /// answers; it has no such arm; it does not say where the arm is; in other axes.
  static Result<std::unique_ptr<HaplyArm>> open(const Place& place, const arm::Geometry& arm, int rate_hz);
  ~HaplyArm() override;

  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME override;
  void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME override;
  void cut() noexcept UNDERACT_REAL_TIME override;
  Problems reopen() override;
  Sentence fixedRateReason() const override { return {}; }
  void setRate(int rate_hz) override;
  Sentence trouble() const override;
  std::vector<std::string> listing() const override;
  servo::DeviceInfo info() const override;

 private:
  enum class Loss : std::uint8_t { None, Line, Silence, Arm, Words };
  /// A state as it came.
  struct Taken {
    std::uint64_t number = 0;
    std::int64_t came_ns = 0;
    Vec3 p_WT = Vec3::Zero();
    Mat3 R_WT = Mat3::Identity();
    bool has_grip = false, is_able = false;  // able: calibrated, with power, ready
    std::uint32_t buttons = 0, epoch = 0;
  };
  struct Wanted {
    std::uint64_t number = 0;
    Vec3 f_H = Vec3::Zero();
  };
  HaplyArm(Place place, const arm::Geometry& arm, int rate_hz);
  Problems connect();
  Problems awaitFirst();
  void disconnect();
  void run();
  void hear();
  void take();
  void speak(std::int64_t now_ns);
  void lose(Loss loss);
  std::int64_t staleAfter_ns() const noexcept;
  Sentence wordsOf(Loss loss) const;
  static Loss lossOf(Heard heard);  // where no state comes any more

  const Place place_;
  const arm::Geometry arm_;
  std::atomic<std::int64_t> period_ns_;
  // Of the connection; no thread runs while they change.
  std::unique_ptr<Line> line_;
  Form form_ = Form::Values;
  std::thread thread_;
  mutable std::mutex words_mutex_;  // never in the tick
  Told told_;
  // Between threads.
  servo::Slot<Taken> taken_;
  servo::Slot<Wanted> wanted_;
  system::Doorbell came_, wrote_;
  std::atomic<bool> ends_{false}, is_cut_{false};
  std::atomic<Loss> loss_{Loss::None};
  std::atomic<Heard> heard_{Heard::Nothing};  // last, of what says anything of the arm
  std::atomic<int> missed_{0};                // reads in a row that had none
  // The thread's.
  std::uint64_t states_ = 0, sent_ = 0;
  std::int64_t came_ns_ = 0, sent_ns_ = 0, wrote_ns_ = 0;
  int unanswered_ = 0;
  std::uint32_t epoch_ = 0;
  bool was_able_ = false;
  std::string text_;
  // The tick's.
  std::int64_t opened_ns_ = 0;
  std::int64_t time_ns_ = 0;  // of the last sample
  std::uint64_t number_ = 0, writes_ = 0;
  bool pushes_ = false;  // the last sample was within reach, of an arm that is able
};

}  // namespace underact::device::haply
