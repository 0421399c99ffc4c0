#pragma once
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "device/input/device_enumerator.h"
#include "device/input/space_mouse.h"

namespace underact::device::input {

/// 3D mice over HID. A thread reads them, and looks every second for newly plugged ones; a mouse that sends nothing for
/// kSilent_ns is at rest, whatever it sent last (its buttons stay: they are sent once).
class SpaceMice final : public DeviceEnumerator {
 public:
  static constexpr std::int64_t kSilent_ns = 250'000'000, kSearchEvery_ns = 1'000'000'000;

  /// The bus must outlive it. The thread starts with the first poll().
  explicit SpaceMice(HidBus& bus, std::int64_t search_every_ns = kSearchEvery_ns);
  ~SpaceMice() override;
  std::vector<DeviceState> poll() override;

 private:
  struct Mouse {
    HidNode node;
    const SpaceMouseModel* model = nullptr;
    std::unique_ptr<HidPipe> pipe;  // null: it cannot be opened
    std::vector<Missing> missing;
    Readings readings;
    std::int64_t moved_ns = 0;
  };
  void run();
  void search();
  void open(Mouse& mouse);
  bool read(Mouse& mouse, int time_ms);
  void publish();

  HidBus& bus_;
  const std::int64_t search_every_ns_;
  std::vector<Mouse> mice_;  // the thread's
  std::mutex mutex_;
  std::condition_variable ending_;
  std::vector<DeviceState> seen_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace underact::device::input
