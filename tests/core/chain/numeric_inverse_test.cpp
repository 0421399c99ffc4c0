#include "core/chain/numeric_inverse.h"

#include "core/chain/normal_equations.h"
#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

/// The residuals that a solution claims are those of its q.
void expectHonest(const Chain& chain, const Pose& X_WT, const NumericSolution& found) {
  const Pose X = forward(chain, std::span<const double>(found.q).first(chain.joints.size()));
  EXPECT_NEAR((X.translation() - X_WT.translation()).norm(), found.residual_m, 1e-13);
  const double turn_rad = Eigen::AngleAxisd(X_WT.linear() * X.linear().transpose()).angle();
  EXPECT_NEAR(turn_rad, found.residual_rad, 1e-7);
}

TEST(DampedStep, IsTheLeastSquaresStep) {  // oracle: Eigen's own, over J stacked on the root of the damping
  test::property::Random random({40});
  for (int draw = 0; draw < 300; ++draw) {
    const std::size_t count = 1 + random.below(kMaxJoints);
    const std::uint32_t held = static_cast<std::uint32_t>(random.bits()) & static_cast<std::uint32_t>(random.bits());
    const double damping = std::pow(10.0, random.between(-6, 1));
    Jacobian J(6, static_cast<Eigen::Index>(count));
    Residual e;
    for (Eigen::Index i = 0; i < J.size(); ++i) J.data()[i] = random.between(-1, 1);
    for (double& one : e) one = random.between(-1, 1);
    for (const Eigen::Index rows : {3, 6}) {
      Eigen::MatrixXd stacked = Eigen::MatrixXd::Zero(rows + J.cols(), J.cols());
      for (Eigen::Index i = 0; i < J.cols(); ++i) {
        if ((held >> static_cast<unsigned>(i) & 1U) == 0U) stacked.col(i).head(rows) = J.col(i).head(rows);
        stacked(rows + i, i) = std::sqrt(damping);
      }
      Eigen::VectorXd wanted = Eigen::VectorXd::Zero(stacked.rows());
      wanted.head(rows) = e.head(rows);
      const Eigen::VectorXd expected = stacked.colPivHouseholderQr().solve(wanted);
      JointStep dq;
      ASSERT_TRUE(dampedStep(J, e, static_cast<std::size_t>(rows), damping, held, dq));
      EXPECT_LE((dq.head(J.cols()) - expected).norm(), 1e-7 * (1 + expected.norm())) << "draw " << draw;
      EXPECT_EQ(dq.tail(static_cast<Eigen::Index>(kMaxJoints) - J.cols()).norm(), 0.0);
    }
  }
}

TEST(DampedStep, SaysThatItNeedsDamping) {
  JointStep dq;
  EXPECT_FALSE(dampedStep(Jacobian::Zero(6, 2), Residual::Ones(), 6, 0.0, 0, dq));
  EXPECT_TRUE(dampedStep(Jacobian::Zero(6, 2), Residual::Ones(), 6, 1.0, 0, dq));
  EXPECT_EQ(dq, JointStep::Zero());
}

TEST(NumericInverse, ConvergesInAFewStepsFromNearby) {
  test::property::Random random({41});
  for (const test::Arm& arm : test::arms()) {
    const Chain chain = arm.chain();
    int reached = 0, steps = 0;
    const int draws = test::property::sweep(300, 20000);
    for (int draw = 0; draw < draws; ++draw) {
      const std::vector<double> q = test::anyValues(random, chain);
      std::vector<double> start = q;
      for (double& one : start) one += random.between(-0.1, 0.1);
      const Pose X_WT = forward(chain, q);
      const NumericSolution found = solveNumerically(chain, X_WT, start, {});
      expectHonest(chain, X_WT, found);
      EXPECT_EQ(found.reached, found.residual_m <= 1e-9 && found.residual_rad <= 1e-9);
      EXPECT_EQ(found.restarts_used, 0);
      reached += found.reached ? 1 : 0;
      steps += found.steps;
    }
    // 0.1 rad is near nowhere when a singular place lies between; one in a hundred draws is.
    EXPECT_GE(reached, draws * 98 / 100) << arm.name;
    EXPECT_LE(steps, draws * 6) << arm.name;
  }
}

TEST(NumericInverse, FindsAWayFromAnywhereWithRestarts) {
  test::property::Random random({42});
  NumericOptions options;
  options.restarts = 20;
  for (const test::Arm& arm : test::arms()) {
    const Chain chain = arm.chain();
    int reached = 0;
    const int draws = test::property::sweep(300, 20000);
    for (int draw = 0; draw < draws; ++draw) {
      const Pose X_WT = forward(chain, test::anyValues(random, chain));
      options.seed = random.bits();
      reached += solveNumerically(chain, X_WT, test::anyValues(random, chain), options).reached ? 1 : 0;
    }
    // A single start arrives in 97 to 99 of 100 (measured), so 21 all but never fail together; poses on an edge,
    // where the last digits come slowly, are the rest.
    EXPECT_GE(reached, draws * 995 / 1000) << arm.name;
  }
}

TEST(NumericInverse, KeepsTheLimitsWhenAsked) {
  test::property::Random random({43});
  NumericOptions options;
  options.restarts = 50;
  options.within_limits = true;
  for (const test::Arm& arm : {test::puma(), test::irb120()}) {
    const Chain chain = arm.chain();
    int reached = 0;
    for (int draw = 0; draw < 200; ++draw) {
      std::vector<double> q;
      for (const Joint& joint : chain.joints) q.push_back(random.between(joint.min, joint.max));
      const NumericSolution found = solveNumerically(chain, forward(chain, q), test::anyValues(random, chain), options);
      reached += found.reached ? 1 : 0;
      for (std::size_t i = 0; i < 6; ++i) {
        ASSERT_GE(found.q[i], chain.joints[i].min);
        ASSERT_LE(found.q[i], chain.joints[i].max);
      }
    }
    EXPECT_GE(reached, 198) << arm.name;
  }
}

TEST(NumericInverse, SlidesAlongALimitToTheNearestPlace) {  // by hand: two slides, one of them short
  Joint along_x{JointType::Prismatic, Vec3::UnitX(), Vec3::Zero(), -0.1, 0.1};
  Joint along_y{JointType::Prismatic, Vec3::UnitY(), Vec3::Zero(), -1.0, 1.0};
  const Chain chain{{along_x, along_y}, Pose::Identity()};
  NumericOptions options;
  options.within_limits = true;
  const Pose X_WT = test::poseOf(Mat3::Identity(), Vec3(0.5, 0.3, 0));
  const NumericSolution found = solveNumerically(chain, X_WT, {}, options);
  EXPECT_FALSE(found.reached);
  EXPECT_NEAR(found.q[0], 0.1, 1e-12);
  EXPECT_NEAR(found.q[1], 0.3, 1e-6);
  EXPECT_NEAR(found.residual_m, 0.4, 1e-9);
  options.within_limits = false;
  EXPECT_TRUE(solveNumerically(chain, X_WT, {}, options).reached);
}

TEST(NumericInverse, BringsThePlaceAloneWhereTheTurnDoesNotCount) {
  test::property::Random random({44});
  NumericOptions options;
  options.rotation_length_m = 0.0;
  options.restarts = 20;
  for (const std::size_t count : {3U, 8U}) {
    for (int draw = 0; draw < 100; ++draw) {
      test::Arm arm = test::omni();
      arm.rows.resize(3);
      arm.X_NT.translation() = Vec3(0, -0.149352, 0);
      if (count == 8) arm = test::anyArm(random, 8);
      const Chain chain = arm.chain();
      Pose X_WT = forward(chain, test::anyValues(random, chain));
      X_WT.linear() = test::about(random.direction(), 1.0) * X_WT.linear();
      const NumericSolution found = solveNumerically(chain, X_WT, test::anyValues(random, chain), options);
      EXPECT_TRUE(found.reached) << count << " joints, draw " << draw;
      expectHonest(chain, X_WT, found);
    }
  }
}

TEST(NumericInverse, TakesChainsOfManyJoints) {
  test::property::Random random({45});
  NumericOptions options;
  options.restarts = 20;
  int reached = 0;
  for (int draw = 0; draw < 100; ++draw) {
    const Chain chain = test::anyArm(random, 7 + random.below(10)).chain();
    const Pose X_WT = forward(chain, test::anyValues(random, chain));
    reached += solveNumerically(chain, X_WT, test::anyValues(random, chain), options).reached ? 1 : 0;
  }
  EXPECT_GE(reached, 99);
}

TEST(NumericInverse, ComesNearestToWhatIsOutOfReach) {  // by hand: the arm stretched towards it
  const Chain chain = test::omni().chain();
  NumericOptions options;
  options.rotation_length_m = 0.0;
  options.max_steps = 500;
  const Vec3 p_WB(0, 0.030, -0.176);
  const Pose X_WT = test::poseOf(Mat3::Identity(), p_WB + Vec3(0.3, 0.2, 0.6));
  const NumericSolution found = solveNumerically(chain, X_WT, std::array<double, 6>{0.1, 0.2, 0.3}, options);
  EXPECT_FALSE(found.reached);
  EXPECT_NEAR(found.residual_m, 0.7 - (0.127508 + 0.149352), 1e-6);
  EXPECT_LT(found.steps, 200);  // it notices
}

TEST(NumericInverse, AnswersInsideATurn) {
  const Chain chain = test::puma().chain();
  const std::array<double, 6> q{3.0, -2.0, 1.0, 2.0, 1.0, -2.0};
  std::array<double, 6> start = q;
  for (double& one : start) one += 4 * kPi + 0.01;
  const NumericSolution found = solveNumerically(chain, forward(chain, q), start, {});
  ASSERT_TRUE(found.reached);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found.q[i], q[i], 1e-7);
}

TEST(NumericInverse, HalfATurnAwayStillKnowsTheWay) {  // where the turn's own formula loses its axis
  const Chain chain{{Joint{}}, Pose::Identity()};
  for (const double away_rad : {kPi, kPi - 1e-9, kPi - 1e-6, 3.0}) {
    const Pose X_WT = test::poseOf(test::about(Vec3::UnitZ(), away_rad), Vec3::Zero());
    const NumericSolution found = solveNumerically(chain, X_WT, {}, {});
    EXPECT_TRUE(found.reached) << away_rad;
    EXPECT_NEAR(std::abs(found.q[0]), away_rad, 1e-8);
  }
}

TEST(NumericInverse, ExactlyHalfATurnIsSeen) {  // R - R^T is all zero there, and says nothing
  test::property::Random random({47});
  for (int draw = 0; draw < 50; ++draw) {
    const Vec3 axis_W = random.direction();
    const Chain chain{{Joint{JointType::Revolute, axis_W}}, Pose::Identity()};
    const Mat3 half = 2.0 * axis_W * axis_W.transpose() - Mat3::Identity();
    const NumericSolution found = solveNumerically(chain, test::poseOf(half, Vec3::Zero()), {}, {});
    EXPECT_TRUE(found.reached);
    EXPECT_NEAR(std::abs(found.q[0]), kPi, 1e-8);
  }
}

TEST(NumericInverse, OtherJointsTakeOverWhereOneStandsAtItsLimit) {  // by hand: the foot of (0.4, 0.3) on the diagonal
  Joint along_x{JointType::Prismatic, Vec3::UnitX(), Vec3::Zero(), -0.1, 0.1};
  Joint slanted{JointType::Prismatic, Vec3(1, 1, 0).normalized(), Vec3::Zero(), -1.0, 1.0};
  NumericOptions options;
  options.within_limits = true;
  const Pose X_WT = test::poseOf(Mat3::Identity(), Vec3(0.5, 0.3, 0));
  const NumericSolution found = solveNumerically({{along_x, slanted}, Pose::Identity()}, X_WT, {}, options);
  EXPECT_NEAR(found.q[0], 0.1, 1e-12);
  EXPECT_NEAR(found.q[1], 0.35 * std::sqrt(2.0), 1e-6);
}

TEST(NumericInverse, NeverEndsFurtherAwayThanItStarted) {
  test::property::Random random({48});
  const Chain chain = test::puma().chain();
  NumericOptions options;
  options.rotation_length_m = 0.0;
  for (int draw = 0; draw < 300; ++draw) {
    const Pose X_WT = test::anyPose(random, 1.0);
    const std::vector<double> start = test::anyValues(random, chain);
    const double before_m = (forward(chain, start).translation() - X_WT.translation()).norm();
    options.max_steps = 1 + draw % 4;
    EXPECT_LE(solveNumerically(chain, X_WT, start, options).residual_m, before_m);
  }
}

TEST(NumericInverse, DrawsItsStartsWithinTheLimits) {  // no steps: the nearer of the start and the draw is the answer
  const Chain chain{{Joint{JointType::Prismatic, Vec3::UnitX(), Vec3::Zero(), 1.0, 2.0}}, Pose::Identity()};
  NumericOptions options;
  options.max_steps = 0;
  options.restarts = 1;
  const Pose X_WT = test::poseOf(Mat3::Identity(), Vec3(1.5, 0, 0));
  for (options.seed = 0; options.seed < 30; ++options.seed) {
    const NumericSolution found = solveNumerically(chain, X_WT, {}, options);
    EXPECT_GE(found.q[0], 1.0);
    EXPECT_LE(found.q[0], 2.0);
  }
}

TEST(NumericInverse, WrapsToPlusPi) {
  const Chain chain{{Joint{}}, Pose::Identity()};
  const std::array<double, 1> start{-3.0 * kPi};
  EXPECT_EQ(solveNumerically(chain, forward(chain, start), start, {}).q[0], kPi);
}

TEST(NumericInverse, IsTheSameEveryTime) {
  test::property::Random random({46});
  const Chain chain = test::puma().chain();
  const Pose X_WT = test::anyPose(random, 0.4);
  NumericOptions options;
  options.restarts = 10;
  const NumericSolution one = solveNumerically(chain, X_WT, {}, options),
                        two = solveNumerically(chain, X_WT, {}, options);
  EXPECT_EQ(one.q, two.q);
  EXPECT_EQ(one.steps, two.steps);
}

TEST(NumericInverse, DoesNotReachAPoseWithNaNs) {
  const Chain chain = test::puma().chain();
  Pose X_WT = chain.X_WT_home;
  X_WT.translation().x() = kNotANumber;
  NumericOptions options;
  options.restarts = 3;
  const std::array<double, 6> start{0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const NumericSolution found = solveNumerically(chain, X_WT, start, options);
  EXPECT_FALSE(found.reached);
  EXPECT_EQ(found.q[2], 0.3);
  EXPECT_EQ(found.residual_m, kInfinity);
  EXPECT_LT(found.steps, 4 * options.max_steps);  // and it does not try for ever
}

}  // namespace
}  // namespace underact::chain
