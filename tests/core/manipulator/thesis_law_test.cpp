#include "core/manipulator/thesis_law.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/manipulator/follow.h"
#include "tests/core/manipulator/chains.h"

namespace underact::manipulator {
namespace {

Manipulator thesisRing(const Vec3& p_WJ = Vec3::Zero()) {
  Wanted wanted;
  wanted.chain = test::chainOf({test::turning(Vec3::UnitZ(), p_WJ)}, test::tipAt(p_WJ + Vec3(0.05, 0, 0)));
  wanted.ko_N_m_per_rad = 0.25;
  wanted.law = ForceLaw::Thesis52;
  return test::made(wanted);
}

Vec3 atAngle(double radius_m, double angle_rad) {
  return radius_m * Vec3(std::cos(angle_rad), std::sin(angle_rad), 0.0);
}

/// A stylus at p, its z in the plane of the circle at an angle, raised out of it by another.
Pose stylus(const Vec3& p_WT, double angle_rad, double raised_rad = 0.0) {
  const Mat3 out = test::tipAt(Vec3::Zero()).linear();
  return test::poseOf(test::about(Vec3::UnitZ(), angle_rad) * test::about(-Vec3::UnitY(), raised_rad) * out, p_WT);
}

}  // namespace

TEST(ThesisLaw, ACaseByHand) {
  // 60 mm out at 90 degrees, the stylus at 60: e = 30 degrees, and the pull goes back towards 60.
  const Vec3 p_WJ(0.01, -0.02, 0.03);
  const ThesisPull pull = thesisPull(thesisRing(p_WJ), stylus(p_WJ + Vec3(0, 0.06, 0.007), kPi / 3));
  EXPECT_TRUE(pull.is_unique);
  EXPECT_NEAR(pull.theta_rad, kPi / 2, 1e-15);
  EXPECT_NEAR(pull.error_rad, kPi / 6, 1e-15);
  EXPECT_LE((pull.p_WP - p_WJ - Vec3(0, 0.05, 0)).norm(), 1e-16);
  EXPECT_LE((pull.f_along_T_W - Vec3(0.25 * kPi / 6 / 0.05, 0, 0)).norm(), 1e-14);
  EXPECT_LE((pull.moment_W - Vec3(0, 0, 0.25 * kPi / 6)).norm(), 1e-15);
}

TEST(ThesisLaw, ThePivotIsTheJointsPointAndTheLengthReachesFromThereToTheTip) {
  Wanted wanted;  // the tip 40 mm out and 30 mm above the point: 50 mm from it
  wanted.chain = test::chainOf({test::turning(Vec3::UnitZ(), Vec3::Zero())}, test::tipAt({0.04, 0, 0.03}));
  wanted.ko_N_m_per_rad = 0.25;
  wanted.law = ForceLaw::Thesis52;
  const ThesisPull pull = thesisPull(test::made(wanted), stylus({0, 0.06, 0.007}, kPi / 3));
  EXPECT_LE((pull.p_WP - Vec3(0, 0.05, 0)).norm(), 1e-16);
  EXPECT_LE((pull.f_along_T_W - Vec3(0.25 * kPi / 6 / 0.05, 0, 0)).norm(), 1e-14);
}

TEST(ThesisLaw, TheErrorIsWrappedSoThatThePullIsNeverMoreThanHalfATurns) {
  test::property::Random random(test::property::Seed{20070651});
  const Manipulator m = thesisRing();
  for (int i = 0; i < test::property::sweep(5'000, 100'000); ++i) {
    const double phi_rad = random.between(-kPi, kPi), alpha_rad = random.between(-kPi, kPi);
    const ThesisPull pull = thesisPull(m, stylus(atAngle(0.06, phi_rad), alpha_rad, random.between(-1.2, 1.2)));
    ASSERT_LE(pull.f_along_T_W.norm(), 0.25 * kPi / 0.05 * (1.0 + 1e-14));
    ASSERT_NEAR(std::remainder(pull.error_rad - (phi_rad - alpha_rad), 2.0 * kPi), 0.0, 1e-14);
    const Vec3 t_W = atAngle(1.0, phi_rad + kPi / 2);
    ASSERT_LE(pull.f_along_T_W.dot(t_W) * pull.error_rad, 0.0);  // it always turns back
  }
}

TEST(ThesisLaw, OnTheAxisThereIsNoPull) {
  const Manipulator m = thesisRing({0.01, 0.02, 0.03});
  for (const double height_m : {0.0, 0.02, -0.1}) {
    const Pose X_WT = stylus(Vec3(0.01, 0.02, 0.03 + height_m), 0.3);
    const ThesisPull pull = thesisPull(m, X_WT);
    EXPECT_FALSE(pull.is_unique);
    EXPECT_EQ(pull.p_WP, X_WT.translation());
    EXPECT_EQ(pull.f_along_T_W, Vec3::Zero());
    EXPECT_EQ(pull.moment_W, Vec3::Zero());
    State state;
    const Followed followed = follow(m, X_WT, 1e-3, state);
    EXPECT_FALSE(followed.is_unique);
    EXPECT_EQ(followed.p_WP, X_WT.translation());
  }
}

TEST(ThesisLaw, NearTheAxisTheTipIsStillOnItsCircle) {
  const Manipulator m = thesisRing();
  for (const double off_m : {1e-12, 1e-9, 1e-6}) {
    const ThesisPull pull = thesisPull(m, stylus(atAngle(off_m, 2.2), 2.0));
    EXPECT_TRUE(pull.is_unique);
    EXPECT_NEAR(pull.theta_rad, 2.2, 1e-14);
    EXPECT_LE((pull.p_WP - atAngle(0.05, 2.2)).norm(), 1e-15);
    EXPECT_NEAR(pull.error_rad, 0.2, 1e-14);
  }
}

TEST(ThesisLaw, WhereTheStylusTurnsAlongTheAxisItsAngleFadesOut) {
  const Manipulator m = thesisRing();
  const Vec3 p_WT = atAngle(0.06, 1.0);
  EXPECT_LE(thesisPull(m, stylus(p_WT, 0.0, kPi / 2)).f_along_T_W.norm(), 1e-20);
  const double whole_N = thesisPull(m, stylus(p_WT, 0.0)).f_along_T_W.norm();
  EXPECT_NEAR(whole_N, 0.25 * 1.0 / 0.05, 1e-13);
  double last_N = whole_N;
  for (double lean_deg = 8.0; lean_deg > 0.0; lean_deg -= 0.01) {
    const double now_N = thesisPull(m, stylus(p_WT, 0.0, (90.0 - lean_deg) * kRadPerDegree)).f_along_T_W.norm();
    ASSERT_LE(now_N, last_N * (1.0 + 1e-9));
    ASSERT_LE(last_N - now_N, whole_N * 1.5 * 0.01 / 5.0 * 1.001);  // the steepest that a smooth step of 5 degrees is
    last_N = now_N;
  }
  EXPECT_LE(last_N, 1e-4 * whole_N);
}

TEST(ThesisLaw, ATipOnItsAxisHasNoCircle) {
  Wanted wanted;
  wanted.chain = test::chainOf({test::turning(Vec3::UnitZ(), Vec3::Zero())}, test::tipAt({0, 0, 0.02}));
  wanted.law = ForceLaw::Thesis52;
  EXPECT_FALSE(thesisPull(test::made(wanted), stylus(atAngle(0.06, 1.0), 0.0)).is_unique);
}

}  // namespace underact::manipulator
