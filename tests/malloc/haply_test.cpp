#include <gtest/gtest.h>

#include "core/safety/gate.h"
#include "device/haply/haply_arm.h"
#include "tests/malloc/counter.h"
#include "tests/support/haply_service.h"

namespace underact::device::haply {

TEST(HaplyArm, AllocatesFreesAndLocksNothingInTheTick) {
  test::HaplyService service;
  const auto arm = HaplyArm::open({"127.0.0.1", service.port()}, arm::findPreset(arm::kDefaultArm)->geometry, 1000);
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

}  // namespace underact::device::haply
