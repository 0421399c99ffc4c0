#include <gtest/gtest.h>

#include "core/safety/gate.h"
#include "device/wooden_haptics/wooden_arm.h"
#include "tests/malloc/counter.h"
#include "tests/support/hid_double.h"

namespace underact::device {

TEST(WoodenArm, AllocatesFreesAndLocksNothingInTheTick) {
  test::WoodenFirmware firmware({});
  test::HidDouble bus(firmware);
  for (const char* preset : {"woodenhaptics", "omni-thesis"}) {
    Result<std::unique_ptr<WoodenArm>> arm = WoodenArm::open(bus, {}, arm::findPreset(preset)->geometry, 1000);
    ASSERT_TRUE(arm);
    safety::GateState state;
    state.level = 1.0;
    int samples = 0;
    {
      test::Watch watch;
      arm::Sample sample;
      for (int tick = 0; tick < 500; ++tick) {
        samples += arm.value()->read(sample) ? 1 : 0;
        arm.value()->write(safety::gate({1.0}, state, {Vec3(0.3, 0.2, 0.1), true, false, {}}, 0.001).force);
        if (tick % 100 == 50) arm.value()->cut();
      }
      EXPECT_EQ(watch.allocations(), 0);
      EXPECT_EQ(watch.frees(), 0);
      EXPECT_EQ(watch.locks(), 0);
    }
    EXPECT_GT(samples, 0);
  }
}

}  // namespace underact::device
