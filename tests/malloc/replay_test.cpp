#include <gtest/gtest.h>

#include "device/replayed_arm.h"
#include "device/simulated_arm.h"
#include "tests/malloc/counter.h"

namespace underact::device {

TEST(ReplayedArm, AReadAllocatesFreesAndLocksNothingWhateverItWasTold) {
  SimulatedArm::Options options;
  options.arm = *arm::findPreset("touch-measured");
  options.model = *sim::findArmModel("vendor-nominal");
  ReplayedArm arm(std::make_unique<SimulatedArm>(options), 1000);
  auto recorded = std::make_shared<Recorded>();
  recorded->rows.resize(100);
  for (std::size_t row = 0; row < 100; ++row) recorded->rows[row].q_rad[0] = 0.001 * static_cast<double>(row);
  const auto readSome = [&arm] {
    arm::Sample sample;
    test::Watch watch;
    for (int read = 0; read < 300; ++read) {
      arm.read(sample);
      arm.write(safety::GatedForce{});
    }
    EXPECT_EQ(watch.allocations(), 0);
    EXPECT_EQ(watch.frees(), 0);
    EXPECT_EQ(watch.locks(), 0);
  };
  for (int round = 0; round < 20; ++round) {  // more places than there is room for, too
    readSome();
    arm.replay(std::make_shared<Recorded>(*recorded));
    arm.setSpeed(0.1 + round);
    arm.play();
    readSome();
    arm.setLoop({{20, 60}});
    arm.seek(50);
    arm.play();
    readSome();
    arm.pause();
    readSome();
    EXPECT_GT(arm.row(), 19.0);
    arm.replay(nullptr);
  }
}

}  // namespace underact::device
