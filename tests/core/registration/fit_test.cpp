#include "core/registration/fit.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/registration/sheet.h"
#include "tests/core/registration/touches.h"
#include "tests/support/property.h"

namespace underact::registration {
namespace {

/// Horn 1987: the turn as the quaternion that is the largest eigenvector of a 4 x 4 matrix; shares no line with the
/// singular values of fitTouches().
Pose hornsPose(const std::vector<Touch>& touches) {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  for (const Touch& touch : touches) {
    from += touch.p_WM / static_cast<double>(touches.size());
    to += touch.p_DM / static_cast<double>(touches.size());
  }
  Mat3 s = Mat3::Zero();
  for (const Touch& touch : touches) s += (touch.p_WM - from) * (touch.p_DM - to).transpose();
  Eigen::Matrix4d n;
  n << s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0),  //
      s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2),   //
      s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1),   //
      s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(n);
  const Eigen::Vector4d q = solver.eigenvectors().col(3);
  Pose X_DW = Pose::Identity();
  X_DW.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  X_DW.translation() = to - X_DW.linear() * from;
  return X_DW;
}

bool isRefused(const std::vector<Touch>& touches, const std::string& word) {
  const Result<Fit> fit = fitTouches(touches);
  if (fit) return false;
  EXPECT_NE(fit.problems().front().sentence.find(word), std::string::npos) << fit.problems().front().sentence;
  return true;
}

TEST(FitTouches, AQuarterTurnWorkedByHand) {
  // The arm stands at (100, 0, 0) mm, turned a quarter to the left about "up": x_W is -z_D, z_W is x_D.
  const std::vector<Touch> touches{
      {{0.0, 0.0, 0.0}, {0.0, 0.0, -0.1}}, {{0.1, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {{0.0, 0.0, -0.05}, {0.05, 0.0, -0.1}}};
  const Fit fit = fitTouches(touches).value();
  Mat3 R_DW;
  R_DW << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  EXPECT_LT((fit.X_DW.linear() - R_DW).norm(), 1e-15);
  EXPECT_LT((fit.X_DW.translation() - Vec3(0.1, 0.0, 0.0)).norm(), 1e-16);
  EXPECT_LT(fit.rms_m, 1e-16);
}

TEST(FitTouches, ThreeMarksOfAnEqualSidedTriangleAreMissedByWhatItIsTooLarge) {
  std::vector<Touch> touches;
  for (int corner = 0; corner < 3; ++corner) {
    const double angle = 2.0943951023931953 * corner;
    const Vec3 trial(std::cos(angle), 0.0, std::sin(angle));
    touches.push_back({0.100 * trial, 0.103 * trial});
  }
  const Fit fit = fitTouches(touches).value();
  EXPECT_NEAR(fit.rms_m, 0.003, 1e-15);  // scale is not fitted
  for (const Vec3& off : fit.off_D) EXPECT_NEAR(off.norm(), 0.003, 1e-15);
  EXPECT_LT((fit.X_DW.matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-14);
}

TEST(FitTouches, ExactPointsGiveTheirPoseBack) {
  test::Random random({20260101});
  for (int draw = 0; draw < test::sweep(500, 20'000); ++draw) {
    const Pose X_DW = anyPose(random);
    const std::size_t count = kFewestMarks + random.below(6);
    const Fit fit = fitTouches(touched(sheetPoints(count), X_DW)).value();
    ASSERT_LT((fit.X_DW.matrix() - X_DW.matrix()).norm(), 1e-13) << draw;
    ASSERT_LT(fit.rms_m, 1e-14);
  }
}

TEST(FitTouches, NoisyPointsGiveHornsPose) {
  test::Random random({20260102});
  for (int draw = 0; draw < test::sweep(500, 20'000); ++draw) {
    const Pose X_DW = anyPose(random);
    std::vector<Vec3> points_D = sheetPoints(kFewestMarks + random.below(6));
    if (draw % 2 == 0) {
      for (Vec3& mark_D : points_D) mark_D += random.inBox(0.04);  // not in a plane
    }
    const std::vector<Touch> touches = touched(points_D, X_DW, 0.003, random);
    const Result<Fit> fit = fitTouches(touches);
    if (!fit) continue;  // drawn onto a line
    ASSERT_NEAR(fit.value().X_DW.linear().determinant(), 1.0, 1e-12);
    ASSERT_LT((fit.value().X_DW.matrix() - hornsPose(touches).matrix()).norm(), 1e-11) << draw;
  }
}

TEST(FitTouches, NoOtherPoseFitsBetter) {
  test::Random random({20260103});
  for (int draw = 0; draw < test::sweep(100, 2'000); ++draw) {
    const std::vector<Touch> touches = touched(sheetPoints(4), anyPose(random), 0.004, random);
    const Fit fit = fitTouches(touches).value();
    for (int trial = 0; trial < 20; ++trial) {
      Pose other = fit.X_DW;
      other.linear() = Eigen::AngleAxisd(0.002, random.direction()).toRotationMatrix() * other.linear();
      other.translation() += 1e-4 * random.direction();
      double sum = 0.0;
      for (const Touch& touch : touches) sum += (other * touch.p_WM - touch.p_DM).squaredNorm();
      ASSERT_GE(std::sqrt(sum / 4.0), fit.rms_m);
    }
  }
}

TEST(FitTouches, AMirroredSetIsFittedByATurnAndNotByAMirror) {
  std::vector<Touch> touches = touched({{0, 0, 0}, {0.1, 0, 0}, {0, 0.07, 0}, {0, 0, 0.05}}, Pose::Identity());
  for (Touch& touch : touches) touch.p_WM.x() = -touch.p_WM.x();
  const Fit fit = fitTouches(touches).value();
  EXPECT_NEAR(fit.X_DW.linear().determinant(), 1.0, 1e-14);
  EXPECT_GT(fit.rms_m, 0.01);
}

TEST(FitTouches, RefusesTouchesThatDetermineNoRotation) {
  const Pose X_DW = standing(0.4);
  EXPECT_TRUE(isRefused(touched({{0, 0, 0}, {0.1, 0, 0}}, X_DW), "3 to 8"));
  EXPECT_TRUE(isRefused(std::vector<Touch>(9), "3 to 8"));
  EXPECT_TRUE(isRefused(touched({{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}}, X_DW), "one line"));
  EXPECT_TRUE(isRefused(touched({{0, 0, 0}, {0.1, 0, 0.001}, {0.2, 0, 0}}, X_DW), "one line"));
  EXPECT_TRUE(isRefused(touched({{0, 0, 0}, {0.1, 0, 0}, {0.1, 0, 0.0005}}, X_DW), "2 and 3"));
  std::vector<Touch> touches = touched(sheetPoints(), X_DW);
  touches[1].p_WM.y() = kNotANumber;
  EXPECT_TRUE(isRefused(touches, "finite"));
  touches = touched(sheetPoints(), X_DW);
  touches[2].p_WM = touches[0].p_WM;
  EXPECT_TRUE(isRefused(touches, "touched points 1 and 3"));
  EXPECT_TRUE(fitTouches(touched({{0, 0, 0}, {0.1, 0, 0.008}, {0.2, 0, 0}}, X_DW)));
}

TEST(Layout, IsOfTheNearestTwoAndTheBestLine) {
  const Layout layout = layoutOf({{0, 0, 0}, {0.1, 0, 0}, {0.1, 0, 0.03}, {0, 0, 0.03}});
  EXPECT_NEAR(layout.min_apart_m, 0.03, 1e-16);
  EXPECT_NEAR(layout.off_line_m, 0.015, 1e-16);
  EXPECT_EQ(layout.near_one + layout.near_other, 3U);  // 1 and 2, or 0 and 3
}

TEST(Sheet, NoOtherOrderOfTheFirstThreeFitsTheirDistances) {
  const std::vector<Vec3> points_D = sheetPoints();
  const double a = (points_D[0] - points_D[1]).norm(), b = (points_D[1] - points_D[2]).norm(),
               c = (points_D[2] - points_D[0]).norm();
  EXPECT_GT(std::abs(a - b), 0.02);
  EXPECT_GT(std::abs(b - c), 0.02);
  EXPECT_GT(std::abs(c - a), 0.02);
  EXPECT_EQ(sheetPoints(8).size(), 8U);
  EXPECT_GT(layoutOf(sheetPoints(8)).min_apart_m, 0.02);
  EXPECT_EQ(awayOf(onDesk(0.1, 0.2, 0.3)), 0.2);
  EXPECT_EQ(onDesk(0.1, 0.2, 0.3), Vec3(0.1, 0.3, -0.2));
}

}  // namespace
}  // namespace underact::registration
