#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/arm/preset.h"
#include "core/servo/device_port.h"
#include "core/servo/slot.h"
#include "core/system/doorbell.h"
#include "device/remote/endpoint.h"
#include "device/remote/message.h"

namespace underact::device::remote {

/// An arm that another program shares. A thread keeps the connection; the tick takes the newest sample from it and
/// leaves the newest force for it. If no new sample is there, the tick waits up to half a period for one; then the last
/// one is used while it is no older than kStale_ns (or kStalePeriods). If the tick wrote no force for kQuietTicks, the
/// other end is sent zero. A lost connection stays lost until reopen().
class RemoteArm final : public servo::DevicePort {
 public:
  static constexpr std::int64_t kStale_ns = 20'000'000;
  static constexpr int kStalePeriods = 5, kQuietTicks = 5;

  /// Problems: not reachable; the wrong key; in use; another version; another arm; another rate.
  static Result<std::unique_ptr<RemoteArm>> open(const Endpoint& endpoint, const arm::Preset& arm, int rate_hz);
  ~RemoteArm() override;

  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME override;
  void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME override;
  void cut() noexcept UNDERACT_REAL_TIME override;
  Problems reopen() override;
  Sentence fixedRateReason() const override;
  Sentence trouble() const override;
  std::vector<std::string> listing() const override;
  servo::DeviceInfo info() const override;

 private:
  /// A sample as it arrived.
  struct Taken {
    std::uint64_t number = 0;
    std::int64_t came_ns = 0;
    SampleMessage message;
    std::uint32_t line = 0;  // counts connections to the arm
  };
  RemoteArm(Endpoint endpoint, const arm::Preset& arm, int rate_hz);
  Problems connect();
  Result<Welcome> ask(Wire& wire);
  void disconnect();
  void run();
  void hear();
  void hear(const Words& words);
  void speak(std::int64_t now_ns);
  void lose(Sentence sentence);
  std::int64_t staleAfter_ns() const noexcept;

  const Endpoint endpoint_;
  const arm::Preset arm_;
  const int rate_hz_;
  const std::int64_t period_ns_;
  std::uint64_t token_ = 0;
  // Of the connection; no thread runs while they change.
  std::unique_ptr<Wire> wire_;
  std::thread thread_;
  std::uint32_t line_ = 0;
  mutable std::mutex words_mutex_;  // never in the tick
  Welcome welcome_;
  Sentence loss_;        // why the connection was lost; empty: it was not
  std::string trouble_;  // of the arm itself
  // Between threads.
  servo::Slot<Taken> taken_;
  servo::Slot<ForceMessage> wanted_;
  system::Doorbell came_;
  system::Doorbell wrote_;
  std::atomic<bool> ends_{false}, is_cut_{false}, is_lost_{false};
  std::atomic<std::int64_t> came_ns_{0};  // the newest sample
  std::atomic<int> missed_{0};            // reads in a row that had none
  // The thread's.
  std::uint64_t samples_ = 0, sequence_ = 0, forces_ = 0, sent_ = 0;
  std::int64_t wrote_ns_ = 0;  // the tick, as seen from here
  std::int64_t sent_ns_ = 0;   // anything sent
  Bytes bytes_;
  // The tick's.
  std::uint64_t number_ = 0, writes_ = 0, answered_ = 0;
  std::uint32_t seen_line_ = 0;
  std::int64_t time_ns_ = 0;   // of the last sample
  std::int64_t ahead_ns_ = 0;  // of the arm's own clock
};

}  // namespace underact::device::remote
