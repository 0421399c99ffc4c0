#include "core/arm/jacobian.h"

#include <Eigen/SVD>
#include <algorithm>

#include "core/arm/forward.h"
#include "tests/core/arm/golden.h"
#include "tests/core/arm/thesis.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

JointAngles randomJoints(test::Random& random) {
  JointAngles q_rad{};
  for (double& angle_rad : q_rad) angle_rad = random.between(-kPi, kPi);
  return q_rad;
}

}  // namespace

TEST(Jacobian, MeetsTheGoldenFile) {
  const test::Value file = test::golden("jacobian.json");
  const test::Value* const cases = file.find("cases");
  ASSERT_EQ(cases->items.size(), 60U);
  for (const test::Value& one : cases->items) {
    const JointAngles q_rad = test::anglesOf(*one.find("q"));
    const Mat6 J = kinematics(thesis().geometry, q_rad).J;
    for (Eigen::Index row = 0; row < 6; ++row) {
      const double unit = row < 3 ? kMetrePerMillimetre : 1.0;
      for (Eigen::Index column = 0; column < 6; ++column) {
        const double wanted =
            one.find("J")->items[static_cast<std::size_t>(row)].items[static_cast<std::size_t>(column)].number;
        ASSERT_NEAR(J(row, column), unit * wanted, 1e-15) << "line " << one.line;  // 0.28 m and 1, some 5 roundings
      }
    }
    // mm^3: the terms of the determinant reach 5e6, whose rounding is 1e-9.
    const Dexterity at = dexterity(thesis().geometry, q_rad);
    ASSERT_NEAR(1e9 * at.det_m3, one.find("det_Jp")->number, 1e-8) << "line " << one.line;
    ASSERT_NEAR(1e9 * at.manipulability_m3, one.find("manipulability_Jp")->number, 1e-8) << "line " << one.line;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double wanted = one.find("singular_values_Jp")->items[static_cast<std::size_t>(axis)].number;
      ASSERT_NEAR(1e3 * at.gain_m[axis], wanted, 1e-11 + 1e-12 * wanted) << "line " << one.line;
    }
    const test::Value* const condition = one.find("cond_Jp");
    if (condition->kind == json::JsonKind::Number) {
      ASSERT_NEAR(at.condition / condition->number, 1.0, 1e-12 * condition->number) << "line " << one.line;
    }
  }
}

TEST(Jacobian, IsTheDerivativeOfThePose) {  // oracle: central differences of tipPose, which shares no line with it
  test::Random random(test::Seed{20070411});
  constexpr double kStep_rad = 1e-5;  // error: step^2 / 6 of the third derivative (0.3 m), and 1e-16 m / step
  for (int i = 0; i < test::sweep(500, 20'000); ++i) {
    const JointAngles q_rad = randomJoints(random);
    const Kinematics at = kinematics(thesis().geometry, q_rad);
    ASSERT_LE((at.X_WT.matrix() - tipPose(thesis().geometry, q_rad).matrix()).cwiseAbs().maxCoeff(), 2e-15);
    ASSERT_EQ((at.J.topLeftCorner<3, 3>()), positionJacobian(thesis().geometry, q_rad));
    for (std::size_t joint = 0; joint < 6; ++joint) {
      JointAngles before = q_rad, after = q_rad;
      before[joint] -= kStep_rad, after[joint] += kStep_rad;
      const Pose A = tipPose(thesis().geometry, before), B = tipPose(thesis().geometry, after);
      const Vec3 v = (B.translation() - A.translation()) / (2 * kStep_rad);
      const Mat3 spin = (B.linear() - A.linear()) / (2 * kStep_rad) * at.X_WT.linear().transpose();
      const Vec3 w(spin(2, 1), spin(0, 2), spin(1, 0));
      const auto column = static_cast<Eigen::Index>(joint);
      ASSERT_LE((at.J.col(column).head<3>() - v).cwiseAbs().maxCoeff(), 1e-10);
      ASSERT_LE((at.J.col(column).tail<3>() - w).cwiseAbs().maxCoeff(), 1e-10);
    }
  }
}

TEST(Jacobian, DeterminantsHaveTheClosedFormsOfTheErrata) {
  test::Random random(test::Seed{20070412});
  for (int i = 0; i < test::sweep(2'000, 100'000); ++i) {
    const JointAngles q_rad = randomJoints(random);
    const Dexterity at = dexterity(thesis().geometry, q_rad);
    const double closed_m3 =
        thesis().geometry.upper_m * thesis().geometry.fore_m * std::cos(q_rad[2]) *
        (thesis().geometry.upper_m * std::cos(q_rad[1]) + thesis().geometry.fore_m * std::sin(q_rad[1] + q_rad[2]));
    const Mat6 J = kinematics(thesis().geometry, q_rad).J;
    ASSERT_NEAR(at.det_m3, closed_m3, 1e-17);  // of 5e-3 m^3
    ASSERT_NEAR((J.topLeftCorner<3, 3>().determinant()), closed_m3, 1e-17);
    ASSERT_NEAR(std::abs(J.determinant()), std::abs(closed_m3 * std::sin(q_rad[4])), 1e-16);
  }
}

TEST(Dexterity, IsTheSingularValueDecomposition) {  // oracle: Eigen's, of the matrix
  test::Random random(test::Seed{20070413});
  for (int i = 0; i < test::sweep(2'000, 100'000); ++i) {
    JointAngles q_rad = randomJoints(random);
    if (i % 7 == 0) q_rad[2] = kPi / 2 + random.between(-1e-6, 1e-6);
    const Dexterity at = dexterity(thesis().geometry, q_rad);
    const Mat3 J = positionJacobian(thesis().geometry, q_rad);
    const Eigen::JacobiSVD<Mat3> svd(J);
    ASSERT_LE((at.gain_m - svd.singularValues()).cwiseAbs().maxCoeff(), 1e-15);
    ASSERT_NEAR(at.axes_W.determinant(), 1.0, 1e-14);
    const Mat3 again = at.axes_W * at.gain_m.cwiseAbs2().asDiagonal() * at.axes_W.transpose();
    ASSERT_LE((again - J * J.transpose()).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(Dexterity, OnASingularityTheConditionIsWithoutEnd) {
  JointAngles on_axis{};
  on_axis[1] = kPi / 2, on_axis[2] = kPi / 2;  // straight up: the wrist centre on axis 1, up to rounding
  EXPECT_GT(dexterity(thesis().geometry, on_axis).condition, 1e15);
  EXPECT_FALSE(std::isnan(dexterity({0.0, 0.0, Vec3::Zero()}, on_axis).condition));  // an arm without length
}

TEST(SingularityDistances, AreThoseOfTheJoints) {
  const SingularityDistances at = singularityDistances(thesis().geometry, {0.4, 0.0, 1.2, 0.3, 2.9, 0.1});
  EXPECT_NEAR(at.shoulder_m, thesis().geometry.upper_m + thesis().geometry.fore_m * std::sin(1.2), 1e-15);
  EXPECT_NEAR(at.elbow_rad, kPi / 2 - 1.2, 1e-15);
  EXPECT_NEAR(at.wrist_rad, kPi - 2.9, 1e-15);
}

}  // namespace underact::arm
