#include "core/chain/kinematics.h"

#include "tests/core/arm/golden.h"
#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

// Chains of up to 16 joints, coordinates below 4 m, each product within an ulp or two.
constexpr double kRotation = 2e-14;
constexpr double kPlace_m = 2e-14;

Pose byTable(const test::Arm& arm, std::span<const double> q) {
  std::vector<Pose> X_WFrames(q.size(), Pose::Identity());
  framesOf(arm.rows, arm.X_WB, q, X_WFrames);
  return X_WFrames.back() * arm.X_NT;
}

TEST(ChainForward, MatchesATurnAndASlideWorkedByHand) {  // by hand
  Joint turn{JointType::Revolute, Vec3::UnitZ(), Vec3(1, 0, 0)};
  Joint slide{JointType::Prismatic, Vec3::UnitX(), Vec3(0, 0, 0)};
  const Chain chain{{turn, slide}, test::poseOf(Mat3::Identity(), Vec3(3, 0, 0))};
  const std::array<double, 2> q{kPi / 2, 0.5};
  const auto [X_WT, J] = kinematics(chain, q);
  EXPECT_LE((X_WT.translation() - Vec3(1, 2.5, 0)).norm(), 1e-15);
  EXPECT_LE((X_WT.linear() * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  Eigen::Matrix<double, 6, 2> byHand;
  byHand << -2.5, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0;
  EXPECT_LE((J - byHand).norm(), 1e-15);
}

TEST(ChainForward, IsThatOfTheTable) {  // oracle: the DH frames, which share only sinCos with it
  test::property::Random random({7});
  for (int draw = 0; draw < test::property::sweep(300, 20000); ++draw) {
    const test::Arm arm = test::anyArm(random, 1 + random.below(kMaxJoints));
    const Chain chain = arm.chain();
    const std::vector<double> q = test::anyValues(random, chain);
    const Pose X_WT = forward(chain, q), expected = byTable(arm, q);
    ASSERT_LE(test::turnBetween(X_WT, expected), kRotation) << "draw " << draw;
    ASSERT_LE(test::wayBetween(X_WT, expected), kPlace_m) << "draw " << draw;
  }
}

TEST(ChainForward, OfTheOmniMeetsTheGoldenPoses) {
  const Chain omni = test::omni().chain();
  const underact::test::Value file = underact::test::golden("fk.json");
  const underact::test::Value* const cases = file.find("cases");
  ASSERT_NE(cases, nullptr);
  ASSERT_EQ(cases->items.size(), 200U);
  for (const underact::test::Value& one : cases->items) {
    const Pose expected = underact::test::poseOf(*one.find("T"));
    const Pose X_WT = forward(omni, underact::test::anglesOf(*one.find("q")));
    ASSERT_LE(test::wayBetween(X_WT, expected), 1e-13) << "line " << one.line;
    ASSERT_LE(test::turnBetween(X_WT, expected), 4e-15) << "line " << one.line;
  }
}

TEST(ChainForward, LinksCarryTheirPoints) {  // each table frame is its home frame, moved
  test::property::Random random({8});
  for (int draw = 0; draw < 100; ++draw) {
    const test::Arm arm = test::anyArm(random, 7);
    const Chain chain = arm.chain();
    const std::vector<double> q = test::anyValues(random, chain), home(7, 0.0);
    std::vector<Pose> X_WNow(7), X_WHome(7), moved(7);
    framesOf(arm.rows, arm.X_WB, q, X_WNow);
    framesOf(arm.rows, arm.X_WB, home, X_WHome);
    const Pose X_WT = forward(chain, q, moved);
    EXPECT_EQ(X_WT.matrix(), forward(chain, q).matrix());
    for (std::size_t i = 0; i < 7; ++i) {
      const Pose frame = moved[i] * X_WHome[i];
      ASSERT_LE((frame.matrix() - X_WNow[i].matrix()).cwiseAbs().maxCoeff(), kPlace_m);
    }
  }
}

TEST(ChainJacobian, IsTheDerivative) {  // oracle: central differences, whose error at this step is below 1e-9
  constexpr double kStep = 1e-5;
  test::property::Random random({9});
  for (int draw = 0; draw < test::property::sweep(100, 5000); ++draw) {
    const Chain chain = test::anyArm(random, 1 + random.below(kMaxJoints)).chain();
    std::vector<double> q = test::anyValues(random, chain);
    const auto [X_WT, J] = kinematics(chain, q);
    ASSERT_EQ(J.cols(), static_cast<Eigen::Index>(q.size()));
    for (std::size_t i = 0; i < q.size(); ++i) {
      const double at = q[i];
      q[i] = at + kStep;
      const Pose after = forward(chain, q);
      q[i] = at - kStep;
      const Pose before = forward(chain, q);
      q[i] = at;
      const Vec3 v = (after.translation() - before.translation()) / (2 * kStep);
      const Mat3 spin = (after.linear() - before.linear()) / (2 * kStep) * X_WT.linear().transpose();
      const Vec3 w(spin(2, 1), spin(0, 2), spin(1, 0));
      const Eigen::Index column = static_cast<Eigen::Index>(i);
      ASSERT_LE((J.col(column).head<3>() - v).norm(), 2e-9) << "draw " << draw << " joint " << i;
      ASSERT_LE((J.col(column).tail<3>() - w).norm(), 2e-9) << "draw " << draw << " joint " << i;
    }
  }
}

TEST(ChainKinematics, IsItsTwoParts) {
  test::property::Random random({10});
  const Chain chain = test::puma().chain();
  const std::vector<double> q = test::anyValues(random, chain);
  EXPECT_EQ(kinematics(chain, q).X_WT.matrix(), forward(chain, q).matrix());
  EXPECT_EQ(kinematics(chain, q).J, jacobian(chain, q));
}

TEST(ChainKinematics, TakesWhatValuesThereAre) {
  const Chain chain = test::puma().chain();
  const std::array<double, 8> long_q{0.1, 0.2, 0.3, 0.0, 0.0, 0.0, 9.0, 9.0};
  const std::span<const double> all(long_q);
  EXPECT_EQ(forward(chain, all).matrix(), forward(chain, all.first(6)).matrix());
  EXPECT_EQ(forward(chain, all.first(3)).matrix(), forward(chain, all.first(6)).matrix());
  EXPECT_EQ(forward(chain, {}).matrix(), forward(chain, std::array<double, 6>{}).matrix());
}

TEST(ChainKinematics, IsNotFiniteForANaN) {
  const Chain chain = test::puma().chain();
  for (const double bad : {kNotANumber, kInfinity}) {
    EXPECT_FALSE(forward(chain, std::array<double, 6>{0, bad}).matrix().allFinite());
  }
}

}  // namespace
}  // namespace underact::chain
