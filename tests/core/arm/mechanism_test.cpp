// The mechanisms of arms: that they move the tip as the kinematics say, which forces their motors can render, and which
// models a scene takes.
#include "core/arm/mechanism.h"

#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/arm/model.h"
#include "core/arm/preset.h"
#include "core/base/units.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

constexpr std::array kSceneArms{"ur5e",     "ur10e",     "puma-560", "abb-irb-120", "kr5",
                                "stanford", "cobra-600", "planar-3", "panda",       "iiwa7"};

const Mechanism& armNamed(const char* name) {
  return *findPreset(name)->geometry.mechanism;
}

JointAngles drawnWithin(const Preset& preset, test::Random& random) {
  JointAngles q{};
  for (std::size_t joint = 0; joint < preset.geometry.mechanism->chain.joints.size(); ++joint) {
    q[joint] =
        random.between(std::max(-kPi, preset.limits.min_rad[joint]), std::min(kPi, preset.limits.max_rad[joint]));
  }
  return q;
}

}  // namespace

TEST(Mechanism, ShippedArmsOfUpToEightJointsAreArmsOfScenes) {
  for (const char* name : kSceneArms) {
    const Preset* const preset = findPreset(name);
    ASSERT_NE(preset, nullptr) << name;
    EXPECT_FALSE(isDevice(*preset)) << name;
    EXPECT_FALSE(solvesInTick(preset->geometry)) << name;
    EXPECT_GT(preset->continuous_force_N, 0.0);
  }
  EXPECT_EQ(jointsOf(findPreset("panda")->geometry), 7U);
  EXPECT_EQ(jointsOf(findPreset("omni-thesis")->geometry), 6U);
  for (const Preset& preset : presets()) EXPECT_TRUE(isDevice(preset)) << preset.name;
}

TEST(Mechanism, RestsWithinItsLimitsAwayFromSingularities) {
  for (const char* name : kSceneArms) {
    const Preset& preset = *findPreset(name);
    const JointAngles& rest = preset.geometry.mechanism->rest;
    EXPECT_TRUE(isWithinLimits(*findModel(name), std::span(rest).first(findModel(name)->rows.size()))) << name;
    const Dexterity dexterity = dexterityOf(preset.geometry, rest);
    EXPECT_GT(dexterity.gain_m[1], 0.03) << name;
  }
}

TEST(Mechanism, TipAndJacobianAreThoseOfItsChain) {
  test::Random random(test::Seed{32});
  for (const char* name : kSceneArms) {
    const Preset& preset = *findPreset(name);
    for (int i = 0; i < 100; ++i) {
      const JointAngles q = drawnWithin(preset, random);
      const chain::Kinematics at = chain::kinematics(armNamed(name).chain, q);
      EXPECT_EQ(tipPosition(preset.geometry, q), at.X_WT.translation());
      EXPECT_EQ(tipPose(preset.geometry, q).matrix(), at.X_WT.matrix());
      EXPECT_EQ(tip(preset.geometry, q).J_p.col(0), Vec3(at.J.col(0).head<3>()));
      EXPECT_EQ(positionJacobian(preset.geometry, q), tip(preset.geometry, q).J_p);
    }
  }
}

TEST(Mechanism, OfEveryArmMovesTheTipAsItsKinematicsSay) {
  test::Random random(test::Seed{20261128});
  for (const Preset& preset : sceneArms()) {
    for (int i = 0; i < 100; ++i) {
      const JointAngles q = drawnWithin(preset, random);
      const Kinematics at = kinematics(preset.geometry, q);
      const chain::Kinematics by_chain = chain::kinematics(preset.geometry.mechanism->chain, q);
      ASSERT_LT((at.X_WT.matrix() - by_chain.X_WT.matrix()).norm(), 1e-14) << preset.name;
      ASSERT_EQ(at.J.cols(), by_chain.J.cols()) << preset.name;
      ASSERT_LT((at.J - by_chain.J).norm(), 1e-14) << preset.name;
      const Kinematics pose = kinematics(preset.geometry, q, {true, false});
      const Kinematics moved = kinematics(preset.geometry, q, {false, true});
      ASSERT_EQ(pose.X_WT.matrix(), at.X_WT.matrix()) << "to the bit, whatever else is asked for: " << preset.name;
      ASSERT_EQ(moved.X_WT.translation(), at.X_WT.translation()) << preset.name;
      ASSERT_EQ(moved.J, at.J.leftCols(moved.J.cols())) << preset.name;
      ASSERT_GE(moved.J.cols(), std::min<Eigen::Index>(3, at.J.cols())) << preset.name;
    }
  }
}

TEST(Mechanism, WithAllJointsDrivenRendersWhateverMovesTheTip) {
  test::Random random(test::Seed{33});
  for (const char* name : {"ur5e", "puma-560", "stanford"}) {
    for (int i = 0; i < 100; ++i) {
      const chain::Jacobian J = chain::jacobian(armNamed(name).chain, drawnWithin(*findPreset(name), random));
      if (Mat3(J.topRows<3>() * J.topRows<3>().transpose()).determinant() < 1e-6) continue;  // near a singularity
      EXPECT_LT((renderable(armNamed(name), J) - Mat3::Identity()).norm(), 1e-14) << name;
    }
  }
}

TEST(Mechanism, InAPlaneRendersNoForceOutOfIt) {
  test::Random random(test::Seed{34});
  const Mechanism& planar = armNamed("planar-3");
  Mat3 plane = Mat3::Identity();
  plane(2, 2) = 0.0;
  for (int i = 0; i < 100; ++i) {
    JointAngles q = drawnWithin(*findPreset("planar-3"), random);
    if (std::abs(std::sin(q[1])) < 0.05) continue;  // stretched, where a direction of the plane is lost
    EXPECT_LT((renderable(planar, chain::jacobian(planar.chain, q)) - plane).norm(), 1e-13);
  }
}

TEST(Mechanism, AnUndrivenJointPassesNoTorqueOn) {  // the part that is left is the nearest such force
  test::Random random(test::Seed{35});
  int all = 0, exact = 0;
  for (const char* name : kSceneArms) {
    const std::size_t joints = armNamed(name).chain.joints.size();
    for (int i = 0; i < 200; ++i) {
      Mechanism arm = armNamed(name);
      for (std::size_t joint = 0; joint < joints; ++joint) arm.driven[joint] = random.between(0.0, 1.0) < 0.6;
      const chain::Jacobian J = chain::jacobian(arm.chain, drawnWithin(*findPreset(name), random));
      const Vec3 asked = random.inBox(10.0);
      const Mat3 P = renderable(arm, J);
      const Vec3 rendered = P * asked;
      EXPECT_LE(rendered.norm(), asked.norm() * (1.0 + 1e-14));
      EXPECT_LE((P - P.transpose()).norm(), 1e-15);
      ++all;
      if ((P * P - P).norm() < 1e-12) {  // nothing fades: a projection, which gives the nearest force
        ++exact;
        EXPECT_LE(std::abs(rendered.dot(asked - rendered)), 1e-11 * asked.squaredNorm());
      }
      for (std::size_t joint = 0; joint < joints; ++joint) {
        if (arm.driven[joint]) continue;
        // A joint with a lever below kMinLever_m fades: at most that times a quarter and the force stays.
        EXPECT_LE(std::abs(J.col(static_cast<Eigen::Index>(joint)).head<3>().dot(rendered)),
                  0.5 * kMinLever_m * asked.norm())
            << name << " joint " << joint + 1;
      }
    }
  }
  EXPECT_GT(exact, 0.97 * all);
}

TEST(Mechanism, TwoOfThreeOfAPlanarArmPushAlongTheLineToTheFreeJoint) {
  Mechanism arm = armNamed("planar-3");
  arm.driven = {true, true, false};
  const JointAngles q{0.3, 0.7, 0.5};
  const chain::Jacobian J = chain::jacobian(arm.chain, q);
  const Mat3 P = renderable(arm, J);
  std::array<Pose, 3> links;
  const Vec3 p_WT = chain::forward(arm.chain, q, links).translation();
  const Vec3 line = (p_WT - links[2] * arm.chain.joints[2].p_WJ).normalized();
  EXPECT_LT((P - line * line.transpose()).norm(), 1e-14);
}

TEST(Mechanism, WatchesAllDrivenJoints) {
  Mechanism arm = armNamed("ur5e");
  arm.driven = {false, true, true, false, true, true};
  Geometry geometry = findPreset("ur5e")->geometry;
  geometry.mechanism = std::make_shared<const Mechanism>(arm);
  const Watched watched = watchedJoints(geometry);
  ASSERT_EQ(watched.count, 4U);
  EXPECT_EQ(watched.joint, (std::array<std::size_t, kMaxJoints>{1, 2, 4, 5}));
  EXPECT_EQ(watchedJoints(findPreset("panda")->geometry).count, 7U);
}

TEST(Mechanism, AMomentIsRenderedBySixOfSixMotorsAndNotByTwoOfThreeOrThreeOfSix) {
  Mechanism planar = armNamed("planar-3");
  planar.driven = {true, true, false};
  EXPECT_FALSE(rendersMoment(planar));
  Mechanism six = armNamed("ur5e");
  EXPECT_TRUE(rendersMoment(six));
  six.driven = {true, true, true};
  EXPECT_FALSE(rendersMoment(six));
  six.driven = {true, true, true, true, true, false};
  EXPECT_FALSE(rendersMoment(six)) << "the undriven joint would have to pass on a torque";
  six.driven.fill(true);
  six.rest[4] = 0.0;  // axes 4 and 6 parallel
  EXPECT_FALSE(rendersMoment(six)) << "at its rest a direction is lost";
  for (const char* name : kSceneArms) {
    const bool spans = jointsOf(findPreset(name)->geometry) >= 6;
    EXPECT_EQ(armNamed(name).renders_moment, spans) << name;
  }
}

TEST(Mechanism, AtASingularityTheWrenchThatNoMotorMakesIsTakenOff) {
  const Mechanism& arm = armNamed("ur5e");
  JointAngles q = arm.rest;
  q[4] = 0.0;
  const chain::Jacobian J = chain::jacobian(arm.chain, q);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(
      Eigen::MatrixXd(Eigen::DiagonalMatrix<double, 6>(Vec6(10, 10, 10, 1, 1, 1)) * J), Eigen::ComputeFullU);
  ASSERT_LT(svd.singularValues()[5], 1e-12);
  const Vec6 lost = svd.matrixU().col(5);
  const Mat6 P = renderableWrench(J, 0.1);
  EXPECT_LT((P * lost).norm(), 1e-12);
  EXPECT_LT((P - (Mat6::Identity() - lost * lost.transpose())).norm(), 1e-10);
}

TEST(Mechanism, NamesWhatASceneCannotHaveWithTheReason) {
  Model model = *findModel("planar-3");
  model.joints[1].sensed = false;
  EXPECT_NE(presetOf(model).problems()[0].sentence.find("Joint 2 is not sensed"), std::string::npos);
  model = *findModel("omni-thesis");
  model.device.reset();
  EXPECT_NE(presetOf(model).problems()[0].sentence.find("is a haptic device"), std::string::npos);
}

TEST(Mechanism, OfTheOmnisFormWithOtherMotorsIsNotTakenForAnOmni) {
  Model model = *findModel("omni-thesis");
  model.joints[2].driven = false;
  const Preset preset = presetOf(model).value();
  ASSERT_FALSE(isDevice(preset));
  const JointAngles q{0.1, 0.6, 0.4, 0.2, 1.5, 0.3};
  EXPECT_LT((tipPosition(preset.geometry, q) - tipPosition(findPreset("omni-thesis")->geometry, q)).norm(), 1e-15);
  EXPECT_EQ(preset.limits.of_wrist_size, model.limits_wrist_size);
}

TEST(Mechanism, AreEqualByContent) {
  const Preset a = presetOf(*findModel("ur5e")).value();
  Model other = *findModel("ur5e");
  EXPECT_EQ(a.geometry, presetOf(other).value().geometry);
  other.joints[3].driven = false;
  EXPECT_FALSE(a.geometry == presetOf(other).value().geometry);
  EXPECT_FALSE(a.geometry == findPreset("omni-thesis")->geometry);
}

}  // namespace underact::arm
