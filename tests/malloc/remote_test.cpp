#include <gtest/gtest.h>

#include "core/safety/gate.h"
#include "tests/malloc/counter.h"
#include "tests/support/shared_arm.h"

namespace underact::device::remote {
namespace {

safety::GatedForce gated(const Vec3& f_T_W) {
  safety::GateState state;
  state.level = 1.0;
  return safety::gate({1.0}, state, {f_T_W, true, false, {}}, 0.001).force;
}

}  // namespace

TEST(RemoteArm, AllocatesFreesAndLocksNothingInTheTick) {
  const test::SharedArm shared;
  auto arm = shared.open();
  ASSERT_TRUE(arm);
  int samples = 0;
  {
    test::Watch watch;
    arm::Sample sample;
    for (int tick = 0; tick < 500; ++tick) {
      samples += arm.value()->read(sample) ? 1 : 0;
      arm.value()->write(gated(Vec3(0.3, 0.2, 0.1)));
      if (tick % 100 == 50) arm.value()->cut();
    }
    EXPECT_EQ(watch.allocations(), 0);
    EXPECT_EQ(watch.frees(), 0);
    EXPECT_EQ(watch.locks(), 0);
  }
  EXPECT_GT(samples, 0);
}

namespace {

/// An arm that takes and gives, and does nothing else.
class Still final : public servo::DevicePort {
 public:
  bool read(arm::Sample& sample) noexcept override {
    sample.q_rad = {0.1, 0.2, -0.3, 0.0, 0.0, 0.0};
    sample.time_ns = time_ns_ += 1'000'000;
    return time_ns_ % 50'000'000 != 0;
  }
  void write(const safety::GatedForce& /*force*/) noexcept override {}
  void cut() noexcept override {}
  servo::DeviceInfo info() const override { return {"Still", true, false}; }

 private:
  std::int64_t time_ns_ = 0;
};

}  // namespace

TEST(RemoteArmSide, AllocatesFreesAndLocksNothingInTheTick) {
  Still arm;
  system::Doorbell bell;
  ArmSide::Options options = optionsOf(*arm::findPreset(arm::kDefaultArm), {}, 1000).value();
  options.allows_force = true;
  ArmSide side(arm, options, bell);
  side.seat(true);
  test::Watch watch;
  for (std::uint64_t tick = 1; tick < 500; ++tick) {
    side.take({tick, side.shown().sample.sequence, Vec3(0.3, 0.2, 0.1), true});
    side.tick();
  }
  EXPECT_EQ(watch.allocations(), 0);
  EXPECT_EQ(watch.frees(), 0);
  EXPECT_EQ(watch.locks(), 0);
}

}  // namespace underact::device::remote
