#include "core/arm/sample.h"
#include "tests/core/arm/golden.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

TEST(Conventions, MeetTheGoldenDeviceAngles) {
  const test::Value file = test::golden("fk.json");
  for (const test::Value& one : file.find("cases")->items) {
    const JointAngles device_rad = deviceFromDh(test::anglesOf(*one.find("q")));
    for (std::size_t joint = 0; joint < 3; ++joint) {  // a sum of two angles below 2 pi: one rounding, in either
      ASSERT_NEAR(device_rad[joint], one.find("device_angles_first3")->items.at(joint).number, 1.8e-15);
    }
  }
}

TEST(Conventions, ThereAndBackIsTheSame) {
  underact::test::Random random(underact::test::Seed{3});
  for (int draw = 0; draw < 1000; ++draw) {
    JointAngles q_rad{};
    for (double& angle_rad : q_rad) angle_rad = random.between(-kPi, kPi);
    const JointAngles back_rad = dhFromDevice(deviceFromDh(q_rad));
    for (std::size_t joint = 0; joint < 6; ++joint)
      ASSERT_NEAR(back_rad[joint], q_rad[joint], 1.8e-15);  // 2 ulp of 2 pi
  }
}

TEST(Conventions, GimbalAtZeroIsTheMiddle) {
  EXPECT_EQ(dhFromDevice({0.1, 0.2, 0.5, 0.0, 0.0, 0.0}), (JointAngles{-0.1, 0.2, 0.3, 0.0, kPi / 2, -kPi / 2}));
}

}  // namespace
}  // namespace underact::arm
