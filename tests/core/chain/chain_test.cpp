#include "core/chain/chain.h"

#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

std::vector<Joint> joints(std::size_t count) {
  return std::vector<Joint>(count);
}

void expectProblem(const Result<Chain>& result, const std::string& sentence) {
  ASSERT_FALSE(result);
  ASSERT_EQ(result.problems().size(), 1U) << result.problems()[0].sentence;
  EXPECT_EQ(result.problems()[0].sentence, sentence);
  EXPECT_EQ(result.problems()[0].place.line, 12);
}

const SourceLocation kPlace{"arm.json", 12};

TEST(MakeChain, TakesOneToSixteenJointsAndMakesAxesUnit) {
  std::vector<Joint> one = joints(1);
  one[0].axis_W = Vec3(0, 3, 4);
  const Result<Chain> chain = makeChain(one, Pose::Identity(), kPlace);
  ASSERT_TRUE(chain);
  EXPECT_LE((chain.value().joints[0].axis_W - Vec3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_TRUE(makeChain(joints(16), Pose::Identity(), kPlace));
  expectProblem(makeChain({}, Pose::Identity(), kPlace), "A chain needs at least one joint.");
  expectProblem(makeChain(joints(17), Pose::Identity(), kPlace), "A chain has at most 16 joints, not 17.");
}

TEST(MakeChain, NamesTheJointThatIsWrong) {
  std::vector<Joint> bad = joints(3);
  bad[1].axis_W = Vec3::Zero();
  expectProblem(makeChain(bad, Pose::Identity(), kPlace), "Joint 2: the axis has no direction.");
  bad[1].axis_W = Vec3(0, kNotANumber, 1);
  expectProblem(makeChain(bad, Pose::Identity(), kPlace), "Joint 2: the axis has no direction.");
  bad = joints(3);
  bad[2].p_WJ.x() = kInfinity;
  expectProblem(makeChain(bad, Pose::Identity(), kPlace), "Joint 3: the point on the axis is not a finite point.");
  const std::string crossed = "Joint 1: the lower limit must not be above the upper one.";
  for (const auto& [low, high] : {std::pair(1.0, 0.5), std::pair(kNotANumber, 1.0), std::pair(kInfinity, kInfinity),
                                  std::pair(-kInfinity, -kInfinity), std::pair(0.0, kNotANumber)}) {
    bad = joints(3);
    bad[0].min = low;
    bad[0].max = high;
    expectProblem(makeChain(bad, Pose::Identity(), kPlace), crossed);
  }
}

TEST(MakeChain, WantsAHomePoseThatIsOne) {
  const std::string rotation = "The upper left 3 x 3 numbers of the home pose are not a rotation matrix.";
  Mat3 mirror = Mat3::Identity();
  mirror(0, 0) = -1;
  Mat3 hole = Mat3::Identity();
  hole(2, 2) = kNotANumber;
  for (const Mat3& bad : {mirror, hole, Mat3(1.001 * Mat3::Identity())}) {
    expectProblem(makeChain(joints(1), test::poseOf(bad, Vec3::Zero()), kPlace), rotation);
  }
  expectProblem(makeChain(joints(1), test::poseOf(Mat3::Identity(), Vec3(0, kInfinity, 0)), kPlace),
                "The position of the home pose is not a finite point.");
}

TEST(MakeChain, TellsOfAllThatIsWrongAtOnce) {
  std::vector<Joint> bad = joints(17);
  bad[4].axis_W = Vec3::Zero();
  bad[4].min = 1;
  bad[4].max = 0;
  EXPECT_EQ(makeChain(bad, test::poseOf(Mat3::Zero(), Vec3::Zero()), kPlace).problems().size(), 4U);
}

TEST(ChainFromDh, HasTheTablesLimitsAndUnitAxes) {
  const Chain chain = test::puma().chain();
  ASSERT_EQ(chain.joints.size(), 6U);
  EXPECT_EQ(chain.joints[1].min, -225 * kRadPerDegree);
  EXPECT_EQ(chain.joints[1].max, 45 * kRadPerDegree);
  for (const Joint& joint : chain.joints) EXPECT_NEAR(joint.axis_W.norm(), 1.0, 2e-16);
  EXPECT_LE((chain.joints[1].axis_W - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_TRUE(makeChain(chain.joints, chain.X_WT_home, {}));
}

TEST(ChainFromDh, LeavesOutWhatItHasNoRoomFor) {
  EXPECT_EQ(chainFromDh(std::vector<DhRow>(20), Pose::Identity(), Pose::Identity()).joints.size(), kMaxJoints);
}

TEST(Reach, IsTheSumOfTheLengths) {
  EXPECT_NEAR(reachOf(test::omni().chain()), 0.127508 + 0.149352, 1e-15);
  Chain slide{joints(2), test::poseOf(Mat3::Identity(), Vec3(0, 0, 0.1))};
  EXPECT_NEAR(reachOf(slide), 0.1, 1e-15);
  slide.joints[1].type = JointType::Prismatic;
  EXPECT_NEAR(reachOf(slide), 0.1, 1e-15);  // without limits it could get anywhere; that is no scale
  slide.joints[1].min = -0.2;
  slide.joints[1].max = 0.05;
  EXPECT_NEAR(reachOf(slide), 0.3, 1e-15);
}

}  // namespace
}  // namespace underact::chain
