#pragma once
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstring>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "device/wooden_haptics/hid_bus.h"

namespace underact::test {

/// In the place of hidapi: a bus with a 3D mouse at it that says what it is told to, and while it is held somewhere
/// says that every 8 ms, as a SpaceNavigator does. For whoever is at both ends: threads of their own, any number.
class SpaceMouseDouble final : public device::HidBus {
 public:
  device::HidNode node{0x046D, 0xC626, 1, 8, "/dev/hidraw3", ""};
  std::atomic<bool> is_allowed = true;

  std::vector<device::HidNode> nodes() override {
    const std::scoped_lock lock(mutex_);
    return is_plugged_ ? std::vector{node} : std::vector<device::HidNode>{};
  }
  Result<std::unique_ptr<device::HidPipe>> open(const device::HidNode& wanted) override {
    const std::scoped_lock lock(mutex_);
    if (!is_plugged_ || wanted.path != node.path) return Problems{{wanted.path + " cannot be opened.", {}}};
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
    ++plugged_;  // whoever held the line before has none
  }
  /// The next report, whatever it is.
  void say(std::vector<std::uint8_t> report) {
    const std::scoped_lock lock(mutex_);
    message_.push_back(std::move(report));
    changed_.notify_all();
  }
  /// Shift and turn, -350 to 350, said again and again until hold() says others, or rest() none any more.
  void hold(const std::vector<int>& shift, const std::vector<int>& turn) {
    const std::scoped_lock lock(mutex_);
    held_ = {report(1, shift), report(2, turn)};
    changed_.notify_all();
  }
  /// Says zeros once, and then nothing; silent: not even zeros.
  void rest(bool silent = false) {
    const std::scoped_lock lock(mutex_);
    held_.clear();
    if (!silent) message_.insert(message_.end(), {report(1, {0, 0, 0}), report(2, {0, 0, 0})});
    changed_.notify_all();
  }

 private:
  using Clock = std::chrono::steady_clock;

  static std::vector<std::uint8_t> report(std::uint8_t id, const std::vector<int>& values) {
    std::vector<std::uint8_t> bytes{id};
    for (const int value : values) {
      bytes.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(value) & 0xFFU));
      bytes.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(value) >> 8U & 0xFFU));
    }
    return bytes;
  }

  class Pipe final : public device::HidPipe {
   public:
    Pipe(SpaceMouseDouble& bus, int plugged) : bus_(bus), plugged_(plugged) {}
    int read(std::span<std::uint8_t> bytes, int time_ms) override {
      return bus_.read(plugged_, bytes, std::chrono::milliseconds(time_ms));
    }
    bool write(std::span<const std::uint8_t>) override { return true; }

   private:
    SpaceMouseDouble& bus_;
    int plugged_;
  };

  int read(int plugged, std::span<std::uint8_t> bytes, std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    const Clock::time_point end = Clock::now() + time;
    for (;;) {
      if (!is_plugged_ || plugged != plugged_) return -1;
      if (!message_.empty()) break;
      if (!held_.empty() && Clock::now() >= next_) {
        message_.insert(message_.end(), held_.begin(), held_.end());
        next_ = Clock::now() + std::chrono::milliseconds(8);
        break;
      }
      if (Clock::now() >= end) return 0;
      changed_.wait_until(lock, held_.empty() ? end : std::min(end, next_));
    }
    const std::vector<std::uint8_t> next = std::move(message_.front());
    message_.pop_front();
    const std::size_t size = std::min(next.size(), bytes.size());
    if (size > 0) std::memcpy(bytes.data(), next.data(), size);
    return static_cast<int>(size);
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool is_plugged_ = true;
  int plugged_ = 0;
  std::deque<std::vector<std::uint8_t>> message_;
  std::vector<std::vector<std::uint8_t>> held_;
  Clock::time_point next_ = Clock::time_point::min();
};

}  // namespace underact::test
