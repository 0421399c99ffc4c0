#include "device/simulated_subject.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/read.h"

namespace underact::device {
namespace {

using calibration::Beam;
using calibration::Trial;

scene::Description beams(const Trial& trial) {
  const std::string path = std::string(UNDERACT_SOURCE) + "/scenes/23_two_beams.json";
  return withStiffness(scene::readSceneFile(path).value(), trial).value();
}

}  // namespace

// The beam and the control's 0.5 N/mm in series; a press of 5 mm on a lever of 60 mm leaves the arc by 0.2 mm,
// which adds 2 % to the softest; encoders and friction add about as much.
TEST(SimulatedSubject, PressesTheBeamsOfTheScene) {
  for (const double stiffness : {0.02, 0.03, 0.06}) {
    const scene::Description scene = beams({Beam::Left, 0.0, stiffness, 0.04});
    const double series = stiffness * 0.5 / (stiffness + 0.5);
    EXPECT_NEAR(pressedStiffness(scene, Beam::Left).value() / series, 1.0, 0.04) << stiffness;
    EXPECT_NEAR(pressedStiffness(scene, Beam::Right).value() / (0.04 * 0.5 / 0.54), 1.0, 0.04);
  }
}

TEST(SimulatedSubject, WithoutNoiseItIsAlwaysRightAndWithNoiseOftenEnough) {
  SimulatedSubject sure{0.0, 1};
  EXPECT_EQ(answerOf(sure, beams({Beam::Left, 0.05, 0.0315, 0.03})).value(), Beam::Left);
  EXPECT_EQ(answerOf(sure, beams({Beam::Right, 0.05, 0.03, 0.0315})).value(), Beam::Right);
  SimulatedSubject unsure{0.2, 1};
  int right = 0;
  constexpr int kTrials = 60;
  for (int i = 0; i < kTrials; ++i) {
    right += answerOf(unsure, beams({Beam::Right, 0.3, 0.03, 0.039})).value() == Beam::Right ? 1 : 0;
  }
  EXPECT_GT(right, kTrials / 2);  // 0.81 expected: below a half would be 6 standard deviations off
  EXPECT_LT(right, kTrials);
}

TEST(SimulatedSubject, TheSameSeedGivesTheSameAnswers) {
  const scene::Description scene = beams({Beam::Left, 0.1, 0.033, 0.03});
  SimulatedSubject one{0.3, 5}, other{0.3, 5};
  for (int i = 0; i < 10; ++i) EXPECT_EQ(answerOf(one, scene).value(), answerOf(other, scene).value());
  EXPECT_EQ(one.random, other.random);
}

}  // namespace underact::device
