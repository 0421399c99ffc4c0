#pragma once
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <memory>
#include <mutex>

#include "core/system/clock.h"
#include "device/wooden_haptics/hid_bus.h"
#include "tests/support/wooden_firmware.h"

namespace underact::test {

/// In the place of hidapi: a bus with one arm at it, whose reports go to and come from a WoodenFirmware, one a
/// millisecond at most, as USB has it. For whoever is at both ends: threads of their own, any number.
class HidDouble final : public device::HidBus {
 public:
  explicit HidDouble(WoodenFirmware& firmware) : firmware_(firmware) {}
  device::HidNode node{0x1234, 0x0006, 0xFFAB, 0x0200, "/dev/hidraw7", "0042"};
  bool is_allowed = true;
  std::vector<device::HidNode> others = {};

  std::vector<device::HidNode> nodes() override {
    const std::scoped_lock lock(mutex_);
    std::vector<device::HidNode> all = others;
    if (is_plugged_) all.push_back(node);
    return all;
  }
  Result<std::unique_ptr<device::HidPipe>> open(const device::HidNode& wanted) override {
    const std::scoped_lock lock(mutex_);
    if (!is_plugged_ || wanted.path != node.path || !is_allowed)
      return Problems{{wanted.path + " cannot be opened.", {}}};
    return std::unique_ptr<device::HidPipe>(std::make_unique<Pipe>(*this, plugged_));
  }
  bool mayOpen(const device::HidNode& /*wanted*/) const override { return is_allowed; }

  void unplug() {
    const std::scoped_lock lock(mutex_);
    is_plugged_ = false;
    changed_.notify_all();
  }
  void plugIn() {
    const std::scoped_lock lock(mutex_);
    is_plugged_ = true;
    is_deaf_ = false;
    ++plugged_;  // whoever held the line before has none
  }
  /// It is plugged in and says nothing.
  void silence(bool on) {
    const std::scoped_lock lock(mutex_);
    is_silent_ = on;
  }
  /// From now on a write takes so long.
  void slowDown(std::chrono::microseconds write) {
    const std::scoped_lock lock(mutex_);
    write_ = write;
  }
  /// So many of the next writes are not taken.
  void refuse(int writes) {
    const std::scoped_lock lock(mutex_);
    refused_ = writes;
  }
  /// From now on reading fails, and writing does not.
  void breakReading() {
    const std::scoped_lock lock(mutex_);
    is_deaf_ = true;
    changed_.notify_all();
  }
  /// The next report, whatever it is.
  void say(std::vector<std::uint8_t> report) {
    const std::scoped_lock lock(mutex_);
    message_.push_back(std::move(report));
    changed_.notify_all();
  }
  /// Reports of the host, of whatever length and content.
  std::int64_t written() const {
    const std::scoped_lock lock(mutex_);
    return written_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kFrame{1};

  class Pipe final : public device::HidPipe {
   public:
    Pipe(HidDouble& bus, int plugged) : bus_(bus), plugged_(plugged) {}
    int read(std::span<std::uint8_t> report, int time_ms) override {
      return bus_.read(plugged_, report, std::chrono::milliseconds(time_ms));
    }
    bool write(std::span<const std::uint8_t> report) override { return bus_.write(plugged_, report); }

   private:
    HidDouble& bus_;
    int plugged_;
  };

  bool isGone(int plugged) const { return !is_plugged_ || plugged != plugged_; }
  /// When the next report is there; never: it is not spoken to.
  Clock::time_point due() const {
    if (!message_.empty()) return Clock::time_point::min();
    if (is_silent_ || (firmware_.onlyAnswers() && !is_asked_)) return Clock::time_point::max();
    return next_;
  }
  int read(int plugged, std::span<std::uint8_t> report, std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    const Clock::time_point end = Clock::now() + time;
    for (;;) {
      if (isGone(plugged) || is_deaf_) return -1;
      const Clock::time_point now = Clock::now();
      if (due() <= now) break;
      if (now >= end) return 0;
      changed_.wait_until(lock, std::min(end, due()));
    }
    std::vector<std::uint8_t> bytes;
    if (!message_.empty()) {
      bytes = std::move(message_.front());
      message_.pop_front();
    } else {
      bytes = firmware_.report(system::monotonicNow_ns());
      is_asked_ = false;
      next_ = Clock::now() + kFrame;
    }
    const std::size_t size = std::min(bytes.size(), report.size());
    if (size > 0) std::memcpy(report.data(), bytes.data(), size);
    return static_cast<int>(size);
  }
  bool write(int plugged, std::span<const std::uint8_t> report) {
    std::unique_lock lock(mutex_);
    if (isGone(plugged) || report.empty() || report[0] != 0) return false;
    if (refused_ > 0) {
      --refused_;
      return false;
    }
    if (write_.count() > 0) {
      changed_.wait_for(lock, write_, [&] { return isGone(plugged); });
      if (isGone(plugged)) return false;
    }
    ++written_;
    firmware_.receive(report.subspan(1), system::monotonicNow_ns());
    if (firmware_.onlyAnswers() && !is_asked_) next_ = Clock::now() + kFrame;
    is_asked_ = true;
    changed_.notify_all();
    return true;
  }

  WoodenFirmware& firmware_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool is_plugged_ = true, is_silent_ = false, is_asked_ = false, is_deaf_ = false;
  int refused_ = 0;
  int plugged_ = 0;
  std::chrono::microseconds write_{0};
  Clock::time_point next_ = Clock::time_point::min();
  std::deque<std::vector<std::uint8_t>> message_;
  std::int64_t written_ = 0;
};

}  // namespace underact::test
