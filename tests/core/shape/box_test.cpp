#include "core/shape/box.h"

#include "core/shape/parallelepiped.h"
#include "tests/support/property.h"

namespace underact::shape {
namespace {

const Box kBox = makeBox({0.01, 0.02, 0.03}, {0.06, 0.08, 0.10}, Mat3::Identity(), {}).value();
const Parallelepiped kSame = scaled(kBox, {1, 1, 1});

void expectBoth(const Vec3& p_CT, const Vec3& p_CP, double height_m) {  // Identity: rounding of a sum or two
  for (const Nearest& nearest : {closestPoint(kBox, kBox.p_WC + p_CT), closestPoint(kSame, kBox.p_WC + p_CT)}) {
    EXPECT_EQ(nearest.status, Status::Unique) << p_CT.transpose();
    EXPECT_LE((nearest.p_WP - kBox.p_WC - p_CP).norm(), 1e-16) << p_CT.transpose();
    EXPECT_NEAR(nearest.height_m, height_m, 1e-16) << p_CT.transpose();
  }
}

void expectTie(const Vec3& p_CT, double depth_m) {
  for (const Nearest& nearest : {closestPoint(kBox, kBox.p_WC + p_CT), closestPoint(kSame, kBox.p_WC + p_CT)}) {
    EXPECT_EQ(nearest.status, Status::NotUnique) << p_CT.transpose();
    EXPECT_EQ(nearest.p_WP, kBox.p_WC + p_CT);
    EXPECT_NEAR(nearest.height_m, -depth_m, 1e-16);
  }
}

TEST(BoxClosestPoint, OutsideItIsOnAFaceAnEdgeOrACorner) {
  expectBoth({0.05, 0.01, -0.02}, {0.03, 0.01, -0.02}, 0.02);
  expectBoth({0.06, 0.08, -0.02}, {0.03, 0.04, -0.02}, 0.05);
  expectBoth({-0.04, -0.06, -0.07}, {-0.03, -0.04, -0.05}, 0.03);
}

TEST(BoxClosestPoint, InsideItIsOnTheNearestFace) {
  expectBoth({0.02, 0.01, 0.03}, {0.03, 0.01, 0.03}, -0.01);
  expectBoth({0.0, -0.03, 0.0}, {0.0, -0.04, 0.0}, -0.01);
  expectBoth({0.01, 0.0, -0.045}, {0.01, 0.0, -0.05}, -0.005);
}

TEST(BoxClosestPoint, HalfwayBetweenFacesNothingIsNearest) {
  expectTie({0, 0, 0}, 0.03);  // opposite faces
  expectTie({0, 0.005, 0.01}, 0.03);
  expectTie({0.02, 0.03, 0}, 0.01);  // neighbours
  expectTie({-0.02, 0.03, 0.04}, 0.01);
}

TEST(BoxClosestPoint, AHairBesideTheTieItIsUnique) {
  expectBoth({1e-12, 0, 0}, {0.03, 0, 0}, -0.03 + 1e-12);
  expectBoth({0.02 + 1e-12, 0.03, 0}, {0.03, 0.03, 0}, -0.01 + 1e-12);
}

TEST(BoxClosestPoint, OnAFaceAnEdgeOrACornerItIsTheTipItself) {
  expectBoth({0.03, 0.01, 0.0}, {0.03, 0.01, 0.0}, 0.0);
  expectBoth({0.03, 0.04, 0.0}, {0.03, 0.04, 0.0}, 0.0);
  expectBoth({0.03, -0.04, 0.05}, {0.03, -0.04, 0.05}, 0.0);
}

TEST(BoxClosestPoint, ATurnedBoxIsTheBoxTurned) {
  test::Random random(test::Seed{20070621});
  for (int draw = 0; draw < test::sweep(2000, 100000); ++draw) {
    const Mat3 R = Eigen::AngleAxisd(random.between(-3, 3), random.direction()).toRotationMatrix();
    const Box turned = makeBox(R * kBox.p_WC, 2.0 * kBox.half_m, R, {}).value();
    const Vec3 p_WT = random.inBox(0.1);
    const Nearest here = closestPoint(kBox, p_WT), there = closestPoint(turned, R * p_WT);
    ASSERT_LE((R * here.p_WP - there.p_WP).norm(), 64 * 0x1p-52 * 0.2);
    ASSERT_NEAR(here.height_m, there.height_m, 64 * 0x1p-52 * 0.2);
  }
}

// The gains of 1 : 1e-12 that make this box thin leave the determinant of a face with 4 digits where it is made of
// squares.
TEST(Parallelepiped, AFaceAlmostFoldedOntoItselfKeepsItsFoot) {
  const Vec3 scale(1.0, 1e-6, 1.0);
  const Mat3 R = Eigen::AngleAxisd(0.7, Vec3(0, 0, 1)).toRotationMatrix();
  const Box box = makeBox(Vec3::Zero(), {0.06, 0.08, 0.10}, R, {}).value();
  test::Random random(test::Seed{20070622});
  for (int draw = 0; draw < 200; ++draw) {
    const Vec3 on = R * Vec3(random.between(-0.025, 0.025), random.between(-0.035, 0.035), 0.05);
    const Vec3 p_WT = scale.cwiseProduct(on + Vec3(0, 0, 0.01));
    const Vec3 back = closestPoint(scaled(box, scale), p_WT).p_WP.cwiseQuotient(scale);
    // An ulp of the scaled coordinates, 1e-17 m, divided by the scale, 64 times; and the face's condition, 1e6, of an
    // ulp.
    ASSERT_LE((back - on).norm(), 64 * 1e-17 / 1e-6) << draw;
  }
}

}  // namespace
}  // namespace underact::shape
