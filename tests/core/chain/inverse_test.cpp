#include <algorithm>
#include <string>

#include "core/chain/redundancy.h"
#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

using test::property::Random;

/// How far two sets of joints are apart, rad or m, the largest.
double jointsApart(const Chain& chain, const JointValues& a, const std::vector<double>& b) {
  double max = 0.0;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const bool turns = chain.joints[i].type == JointType::Revolute;
    max = std::max(max, turns ? std::abs(std::remainder(a[i] - b[i], 2 * kPi)) : std::abs(a[i] - b[i]));
  }
  return max;
}

/// The smallest singular value of the Jacobian at q, lengths in reaches: how far from a singularity.
double marginAt(const Chain& chain, const std::vector<double>& q, Asks asks) {
  Eigen::MatrixXd J = jacobian(chain, q);
  J.topRows(3) /= reachOf(chain);
  if (asks == Asks::Position) J = Eigen::MatrixXd(J.topRows(3));
  const Eigen::VectorXd gains = J.jacobiSvd().singularValues();
  return gains[gains.size() - 1];
}

/// All that a search from many random starts finds: shares no line with the closed forms.
std::vector<std::vector<double>> bruteForce(const Chain& chain, const Pose& X_WT, Asks asks, int starts) {
  std::vector<std::vector<double>> found;
  NumericOptions options;
  if (asks == Asks::Position) options.rotation_length_m = 0.0;
  std::uint64_t random = 7;
  for (int start = 0; start < starts; ++start) {
    const JointValues from = drawnJoints(chain, random);
    const NumericSolution one = solveNumerically(chain, X_WT, std::span(from).first(chain.joints.size()), options);
    if (!one.reached) continue;
    const bool is_new = std::none_of(found.begin(), found.end(), [&](const std::vector<double>& other) {
      return jointsApart(chain, one.q, other) < 1e-4;
    });
    if (is_new) found.emplace_back(one.q.begin(), one.q.begin() + static_cast<std::ptrdiff_t>(chain.joints.size()));
  }
  return found;
}

struct Tally {
  int poses = 0, skipped = 0, max = 0;
  double solutions = 0.0;
};

/// Poses of random joints: the joints are among the solutions, each solution reaches the pose, no two are the same, and
/// for some poses a search by brute force finds as many.
Tally expectAllFound(const Chain& chain, Random& random, int poses, int searched) {
  const Inverse inverse = inverseOf(chain);
  EXPECT_TRUE(inverse.isClosed());
  Tally tally;
  for (int i = 0; i < poses && !testing::Test::HasFailure(); ++i) {
    const std::vector<double> q = test::anyValues(random, chain);
    const Pose X_WT = forward(chain, q);
    const double margin = marginAt(chain, q, inverse.asks);
    if (margin < 1e-4) {
      ++tally.skipped;
      continue;
    }
    ++tally.poses;
    const InverseSolutions found = solveAll(inverse, X_WT);
    double nearest = kInfinity;
    for (std::size_t j = 0; j < found.count; ++j) {
      const InverseSolution& one = found.all[j];
      nearest = std::min(nearest, jointsApart(chain, one.q, q));
      const Pose X = forward(chain, std::span(one.q).first(chain.joints.size()));
      EXPECT_LE(test::wayBetween(X, X_WT), 1e-9);
      if (inverse.asks == Asks::Pose) {
        EXPECT_LE(test::turnBetween(X, X_WT), 1e-9);
      }
    }
    EXPECT_LE(nearest, 1e-9 / margin) << "pose " << i << " of " << found.count << " solutions, margin " << margin;
    tally.max = std::max(tally.max, static_cast<int>(found.count));
    tally.solutions += static_cast<double>(found.count);
    if (i >= searched) continue;
    const std::vector<std::vector<double>> all = bruteForce(chain, X_WT, inverse.asks, 300);
    for (const std::vector<double>& other : all) {
      double away = kInfinity;
      for (std::size_t j = 0; j < found.count; ++j) away = std::min(away, jointsApart(chain, found.all[j].q, other));
      if (marginAt(chain, other, inverse.asks) < 1e-3) continue;
      EXPECT_LE(away, 1e-4) << "pose " << i << ": a search finds another one; the form has " << found.count << ", it "
                            << all.size();
    }
  }
  EXPECT_GT(tally.poses, tally.skipped);
  return tally;
}

Joint turn(const Vec3& axis_W, const Vec3& p_WJ) {
  return {JointType::Revolute, axis_W, p_WJ};
}
Joint slide(const Vec3& axis_W) {
  return {JointType::Prismatic, axis_W, Vec3::Zero()};
}

/// Universal Robots' UR5e, from its maker's (classic) table, as modified rows.
test::Arm ur5e() {
  test::Arm arm{"ur5e",
                {test::row(0, 0, 162.5, 0, -360, 360), test::row(90, 0, 0, 0, -360, 360),
                 test::row(0, -425, 0, 0, -360, 360), test::row(0, -392.2, 133.3, 0, -360, 360),
                 test::row(90, 0, 99.7, 0, -360, 360), test::row(-90, 0, 99.6, 0, -360, 360)}};
  return arm;
}

Chain anyThreeParallel(Random& random, bool meets) {
  const Vec3 n = random.direction();
  Chain chain;
  chain.joints.push_back(turn(random.direction(), random.inBox(0.3)));
  for (int i = 0; i < 3; ++i) chain.joints.push_back(turn(random.below(2) == 0 ? n : Vec3(-n), random.inBox(0.5)));
  const Vec3 five = random.direction(), p_5 = random.inBox(0.3), six = random.direction();
  chain.joints.push_back(turn(five, p_5));
  chain.joints.push_back(turn(six, meets ? Vec3(p_5 + 0.1 * five - 0.2 * six) : random.inBox(0.3)));
  chain.X_WT_home = test::anyPose(random, 0.4);
  return chain;
}

/// Three joints of the types of the bits of kinds (1: prismatic), anywhere.
std::vector<Joint> anyThree(Random& random, unsigned kinds) {
  std::vector<Joint> joints;
  for (unsigned i = 0; i < 3; ++i) {
    joints.push_back((kinds >> i & 1U) != 0 ? slide(random.direction()) : turn(random.direction(), random.inBox(0.3)));
  }
  return joints;
}

void addWristTo(Chain& chain, Random& random) {
  const Vec3 p_WC = random.inBox(0.4);
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis_W = random.direction();
    chain.joints.push_back(turn(axis_W, p_WC + random.between(-0.2, 0.2) * axis_W));
  }
}

TEST(InverseOf, TheUr5eHasEightSolutions) {
  Random random({101});
  const Tally tally = expectAllFound(ur5e().chain(), random, test::property::sweep(1000, 100000), 20);
  EXPECT_EQ(tally.max, 8);
  EXPECT_TRUE(std::holds_alternative<ThreeParallelArm>(inverseOf(ur5e().chain()).form));
}

TEST(InverseOf, AnyThreeParallelAxesHaveAllOfTheirs) {
  Random random({102});
  for (int arm = 0; arm < test::property::sweep(40, 1000) && !HasFailure(); ++arm) {
    SCOPED_TRACE(arm);
    const Chain chain = anyThreeParallel(random, arm % 2 == 0);
    expectAllFound(arm % 4 < 2 ? chain : reversedChain(chain), random, 20, 1);
  }
}

TEST(InverseOf, APositionOfThreeJointsOfAnyKinds) {
  Random random({103});
  for (int arm = 0; arm < test::property::sweep(160, 4000) && !HasFailure(); ++arm) {
    SCOPED_TRACE(arm);
    const Chain chain{anyThree(random, static_cast<unsigned>(arm % 8)), test::anyPose(random, 0.5)};
    expectAllFound(chain, random, 20, 1);
  }
}

TEST(InverseOf, APositionWhereAxesMeetOrAreParallel) {
  Random random({104});
  for (int arm = 0; arm < test::property::sweep(120, 4000) && !HasFailure(); ++arm) {
    SCOPED_TRACE(arm);
    std::vector<Joint> joints = anyThree(random, arm % 2 == 0 ? 0U : 4U);
    const std::size_t which = arm % 4 < 2 ? 1 : (arm % 2 == 0 ? 2 : 1);  // the pair 1, 2 or 2, 3
    Joint &a = joints[which - 1], &b = joints[which];
    if (arm % 3 == 0) b.axis_W = a.axis_W;
    if (arm % 3 == 1) b.p_WJ = a.p_WJ + 0.2 * a.axis_W - 0.1 * b.axis_W;
    if (arm % 3 == 2) b.axis_W = a.axis_W.unitOrthogonal();
    expectAllFound({joints, test::anyPose(random, 0.5)}, random, 20, 1);
  }
}

TEST(InverseOf, AnArmOfThreeJointsFindsThePoseThatItIsInWhereTheElbowIsStraightOrFolded) {
  Random random({103});
  for (const double upper_m : {0.12, 0.13, 0.2}) {
    for (const double aside_m : {0.0, 0.01}) {
      Chain chain;
      chain.joints = {turn(Vec3::UnitZ(), Vec3::Zero()), turn(Vec3::UnitY(), Vec3(2.0 * aside_m, 0.0, 0.1)),
                      turn(Vec3::UnitY(), Vec3(2.0 * aside_m, aside_m, 0.1 + upper_m))};
      chain.X_WT_home.translation() = Vec3(2.0 * aside_m, 0.5 * aside_m, 0.23 + upper_m);
      const Inverse inverse = inverseOf(chain);
      ASSERT_EQ(inverse.asks, Asks::Position);
      for (int pose = 0; pose < 500; ++pose) {
        std::vector<double> q = test::anyValues(random, chain);
        q[2] = pose % 2 == 0 ? 0.0 : kPi;
        if (pose % 5 == 0) q[1] = 0.0;
        const Vec3 p_WT = forward(chain, q).translation();
        Pose X_WT = Pose::Identity();
        X_WT.translation() = p_WT;
        const InverseSolutions found = solveAll(inverse, X_WT);
        ASSERT_GT(found.count, 0U) << pose << ", upper " << upper_m << ", aside " << aside_m;
        for (std::size_t i = 0; i < found.count; ++i)
          ASSERT_LE((forward(chain, std::span(found.all[i].q).first(3)).translation() - p_WT).norm(), 1e-9);
      }
    }
  }
}

TEST(InverseOf, AWristAfterThreeJointsOfAnyKindsInEitherDirection) {
  Random random({105});
  for (int arm = 0; arm < test::property::sweep(64, 2000) && !HasFailure(); ++arm) {
    SCOPED_TRACE(arm);
    Chain chain{anyThree(random, static_cast<unsigned>(arm / 2 % 8)), test::anyPose(random, 0.5)};
    addWristTo(chain, random);
    expectAllFound(arm % 2 == 0 ? chain : reversedChain(chain), random, 20, 1);
  }
}

TEST(InverseOf, AWristAtTheBaseOfAPuma) {
  Random random({106});
  const Chain chain = reversedChain(test::puma().chain());
  EXPECT_TRUE(std::holds_alternative<SphericalWristArm>(inverseOf(chain).form));
  EXPECT_EQ(expectAllFound(chain, random, 300, 5).max, 8);
}

TEST(InverseOf, AReversedChainIsTheInverse) {
  Random random({107});
  for (int draw = 0; draw < 100; ++draw) {
    const Chain chain = test::anyArm(random, 1 + random.below(8)).chain();
    std::vector<double> q = test::anyValues(random, chain);
    const Pose X_WT = forward(chain, q);
    std::reverse(q.begin(), q.end());
    const Pose back = forward(reversedChain(chain), q) * X_WT;
    EXPECT_LE(test::wayBetween(back, Pose::Identity()), 1e-13);
    EXPECT_LE(test::turnBetween(back, Pose::Identity()), 1e-13);
  }
}

TEST(InverseOf, ArmsInAPlaneAndScaras) {  // each order of turns and slides, with and without a quill anywhere
  Random random({108});
  for (int arm = 0; arm < test::property::sweep(168, 4000) && !HasFailure(); ++arm) {
    SCOPED_TRACE(arm);
    const Vec3 n = random.direction();
    const unsigned kinds = static_cast<unsigned>(arm % 7);  // seven: not three slides
    Chain chain{{}, test::anyPose(random, 0.3)};
    const std::size_t count = arm % 3 == 0 ? 2 : 3;
    for (unsigned i = 0; i < count; ++i) {
      const Vec3 in_plane = n.cross(random.direction()).normalized();
      const Vec3 axis = random.below(2) == 0 ? n : Vec3(-n);
      chain.joints.push_back((kinds >> i & 1U) != 0 ? slide(in_plane) : turn(axis, random.inBox(0.3)));
    }
    const bool turns = std::any_of(chain.joints.begin(), chain.joints.end(),
                                   [](const Joint& one) { return one.type == JointType::Revolute; });
    if (!turns) continue;
    if (arm % 2 == 0) {
      chain.joints.insert(chain.joints.begin() + static_cast<std::ptrdiff_t>(random.below(count + 1)),
                          slide(random.below(2) == 0 ? n : Vec3(-n)));
    }
    const Inverse inverse = inverseOf(chain);
    ASSERT_TRUE(std::holds_alternative<PlanarArm>(inverse.form));
    const std::vector<double> q = test::anyValues(random, chain);
    const InverseSolutions found = solveAll(inverse, forward(chain, q));
    double nearest = kInfinity;
    for (std::size_t j = 0; j < found.count; ++j) nearest = std::min(nearest, jointsApart(chain, found.all[j].q, q));
    EXPECT_LE(nearest, 1e-6) << found.count;
    if (inverse.asks == Asks::Pose) {  // a pose out of the plane is none of this arm's
      Pose askew = forward(chain, q);
      askew.linear() = test::about(n.unitOrthogonal(), 1e-3) * askew.linear();
      EXPECT_EQ(solveAll(inverse, askew).count, 0U);
    }
  }
}

TEST(InverseOf, AScaraByHand) {  // 0.4 and 0.3 m, at right angles: the tip at (0.4, 0.3), the quill 0.1 down
  const Vec3 z = Vec3::UnitZ();
  const Chain chain{{turn(z, Vec3::Zero()), turn(z, {0.4, 0, 0}), slide(-z), turn(-z, {0.7, 0, 0})},
                    test::poseOf(Mat3::Identity(), {0.7, 0, 0.2})};
  const InverseSolutions found = solveAll(inverseOf(chain), test::poseOf(Mat3::Identity(), {0.4, 0.3, 0.1}));
  ASSERT_EQ(found.count, 2U);
  double min = kInfinity;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(found.all[i].q[2], 0.1, 1e-12);
    EXPECT_NEAR(found.all[i].q[3], found.all[i].q[0] + found.all[i].q[1], 1e-12);
    min = std::min(min, std::abs(found.all[i].q[0]) + std::abs(found.all[i].q[1] - kPi / 2));
  }
  EXPECT_LE(min, 1e-12);
}

TEST(InverseOf, NothingIsFoundOutOfReachOrForNumbersThatAreNone) {
  for (const Chain& chain : {ur5e().chain(), test::puma().chain(), reversedChain(test::puma().chain())}) {
    const Inverse inverse = inverseOf(chain);
    EXPECT_EQ(solveAll(inverse, test::poseOf(Mat3::Identity(), {5, 0, 0})).count, 0U);
    EXPECT_EQ(solveAll(inverse, test::poseOf(Mat3::Identity(), {kNotANumber, 0, 0})).count, 0U);
    EXPECT_EQ(solveAll(inverse, test::poseOf(Mat3::Identity(), {1e300, 0, 0})).count, 0U);
  }
}

TEST(InverseOf, AnArmWithoutAFormHasNone) {
  Random random({109});
  EXPECT_FALSE(inverseOf(test::anyArm(random, 7).chain()).isClosed());
  Chain chain = ur5e().chain();
  chain.joints[2].axis_W = Vec3(1, 2, 3).normalized();
  EXPECT_FALSE(inverseOf(chain).isClosed());
  EXPECT_EQ(solveAll(inverseOf(chain), chain.X_WT_home).count, 0U);
}

TEST(SelfMotion, NamesTheJointsThatLeaveTheTip) {
  const std::vector<double> straight{0.3, -0.5, 0.4, 0.7, 0.0, 0.2};  // the Omni's wrist in line: q4 and q6
  const std::vector<double> motion = selfMotion(test::omni().chain(), straight, Asks::Pose, 1e-6);
  ASSERT_EQ(motion.size(), 6U);
  EXPECT_NEAR(std::abs(motion[3]), 1.0, 1e-9);
  EXPECT_NEAR(motion[3], -motion[5], 1e-9);
  for (const std::size_t joint : {0U, 1U, 2U, 4U}) EXPECT_NEAR(motion[joint], 0.0, 1e-9);
  EXPECT_TRUE(
      selfMotion(test::omni().chain(), std::vector<double>{0.3, 0.5, 0.4, 0.7, 0.9, 0.2}, Asks::Pose, 1e-6).empty());
}

TEST(SelfMotion, IsOneExactlyWhereTheLeastGainIsBelowTheShare) {
  Random random({36});
  int singular = 0, regular = 0;
  for (const test::Arm& arm : {test::omni(), test::puma(), ur5e()}) {
    const Chain chain = arm.chain();
    for (int trial = 0; trial < 3000; ++trial) {
      std::vector<double> q;
      for (int joint = 0; joint < 6; ++joint) q.push_back(random.between(-kPi, kPi));
      if (trial % 3 == 0) q[4] = std::pow(10.0, random.between(-9.0, 0.0));  // as near to a straight wrist as wanted
      const double relative = std::pow(10.0, random.between(-8.0, -0.5));
      Eigen::MatrixXd J = jacobian(chain, q);
      J.topRows(3) /= reachOf(chain);
      const Eigen::VectorXd gains = J.jacobiSvd().singularValues();
      if (std::abs(gains[5] / gains[0] / relative - 1.0) < 1e-6) continue;  // decided by rounding
      const bool expected = gains[5] < relative * gains[0];
      EXPECT_EQ(!selfMotion(chain, q, Asks::Pose, relative).empty(), expected) << arm.name << ", trial " << trial;
      (expected ? singular : regular)++;
    }
  }
  EXPECT_GT(singular, 1000);
  EXPECT_GT(regular, 3000);
}

}  // namespace
}  // namespace underact::chain
