#include <gtest/gtest.h>

#include "core/arm/sample.h"
#include "core/base/types.h"

namespace underact::arm {
namespace {

const JointAngles kFrom{0.1, -0.2, 0.3, 3.0, 1.0, -1.0}, kTo{-3.0, 0.4, 2.8, -3.0, -1.0, 2.0};

TEST(OnTheWay, EndsAreExactAndHeldBeyond) {
  EXPECT_EQ(interpolated(kFrom, kTo, 0.0), kFrom);
  EXPECT_EQ(interpolated(kFrom, kTo, 1.0), kTo);
  EXPECT_EQ(interpolated(kFrom, kTo, -2.0), kFrom);
  EXPECT_EQ(interpolated(kFrom, kTo, 7.0), kTo);
}

TEST(OnTheWay, EveryJointTurnsEvenlyThroughTheAnglesBetween) {
  const JointAngles quarter = interpolated(kFrom, kTo, 0.25);
  const JointAngles expected{-0.675, -0.05, 0.925, 1.5, 0.5, -0.25};  // joint 4 through 0, not past half a turn
  for (std::size_t joint = 0; joint < 6; ++joint) EXPECT_NEAR(quarter[joint], expected[joint], 1e-15);
}

TEST(OnTheWay, NotANumberStaysOne) {
  EXPECT_TRUE(std::isnan(interpolated({kNotANumber, 0, 0, 0, 0, 0}, kTo, 0.5)[0]));
}

}  // namespace
}  // namespace underact::arm
