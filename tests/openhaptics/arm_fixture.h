#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "core/arm/preset.h"
#include "core/safety/gate.h"
#include "device/openhaptics/openhaptics_arm.h"
#include "tests/openhaptics/stand_in.h"
#include "tests/support/comes.h"

namespace underact::device::openhaptics {

/// The whole force that a hand may get, along x: past the gate, as the servo's is.
inline safety::GatedForce wholeForce() {
  safety::Limits limits;
  limits.max_force_N = 0.88;
  safety::GateInput asked;
  asked.f_T_W = Vec3(5.0, 0.0, 0.0);
  asked.engage = true;
  safety::Gated gated;
  for (int tick = 0; tick < 3; ++tick) gated = safety::gate(limits, gated.next, asked, 1.0);
  return gated.force;
}

/// Pushes in each tick that has a sample; what a servo does, without its soft start.
class Pusher final : public servo::Ticks {
 public:
  explicit Pusher(servo::DevicePort& arm) : arm_(arm) {}
  void tick() noexcept override {
    arm::Sample sample;
    const bool has_sample = arm_.read(sample);
    if (has_sample) buttons = sample.buttons;
    if (has_sample) epoch = sample.epoch;
    arm_.write(has_sample ? force_ : safety::GatedForce{});
    ++ticks;
    if (!has_sample) ++without_sample;
  }
  std::atomic<std::int64_t> ticks{0}, without_sample{0};
  std::atomic<std::uint32_t> buttons{0}, epoch{0};

 private:
  servo::DevicePort& arm_;
  const safety::GatedForce force_ = wholeForce();
};

class OpenHapticsArmTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_NE(test::standIn(), nullptr) << dlerror();
    far = test::standIn();
    far->reset();
  }
  void TearDown() override {
    close();
    if (far != nullptr) far->reset();
  }
  static Result<std::unique_ptr<OpenHapticsArm>> tryToOpen(int at_hz) {
    return OpenHapticsArm::open({*arm::findPreset(arm::kDefaultArm), at_hz, ""});
  }
  void open() {
    Result<std::unique_ptr<OpenHapticsArm>> opened = tryToOpen(rate_hz);
    ASSERT_TRUE(opened) << opened.problems().front().sentence;
    arm = std::move(opened).value();
  }
  void drive() {
    pusher = std::make_unique<Pusher>(*arm);
    ASSERT_TRUE(arm->drive(*pusher, rate_hz)) << arm->trouble();
  }
  void openAndPush() {
    open();
    ASSERT_NE(arm, nullptr);
    drive();
    ASSERT_TRUE(pushesSoon()) << arm->trouble();
  }
  void close() {
    if (arm && pusher) arm->endDrive();
    arm.reset();
    pusher.reset();
  }
  bool pushes() const { return test::forceOf(*far).norm() > 0.1; }
  bool rests() const { return test::forceOf(*far).norm() == 0.0; }
  bool pushesSoon() const {
    return test::comes([this] { return pushes(); });
  }
  bool restsSoon() const {
    return test::comes([this] { return rests(); });
  }
  /// So many more periods have passed.
  bool ticksOn(std::int64_t periods) const {
    const std::int64_t from = pusher->ticks;
    return test::comes([&] { return pusher->ticks >= from + periods; });
  }

  int rate_hz = 1000;
  test::hd::Control* far = nullptr;
  std::unique_ptr<OpenHapticsArm> arm;
  std::unique_ptr<Pusher> pusher;
};

}  // namespace underact::device::openhaptics
