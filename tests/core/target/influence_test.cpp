#include "core/target/influence.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "tests/core/arm/golden.h"
#include "tests/support/property.h"

namespace underact::target {
namespace {

using test::Value;

const shape::Circle kRing = shape::makeCircle(Vec3::Zero(), Vec3::UnitZ(), 0.05, {}).value();
const shape::Circle kTilted = shape::makeCircle({0.01, 0.02, 0.03}, {-1, 1, -1}, 0.04, {}).value();
const shape::Cylinder kTube = shape::makeCylinder({0.03, 0, 0.03}, {-1, 1, -1}, 0.03, {}).value();
const shape::Sphere kBall = shape::makeSphere({0.01, 0, 0.02}, 0.05, {}).value();

Vec3 at(double angle_rad, double radius = 1.0) {
  return radius * Vec3(std::cos(angle_rad), std::sin(angle_rad), 0.0);
}

Vec3 threeOf(const Value& list) {
  return {list.items.at(0).number, list.items.at(1).number, list.items.at(2).number};
}

Influenced from_rest(const shape::Shape& shape, const Influence& influence, const Vec3& p_WT, const Vec3& stylus_W) {
  InfluenceState state;
  return influencedTarget(shape, influence, p_WT, stylus_W, 0.0, state);
}

double apart(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2.0 * kPi));
}

}  // namespace

TEST(Influence, ARadiusThatIsLostInThePlacesRoundingGivesANumber) {  // p + R n is p: no direction is left in it
  const Vec3 far_W(1e3, 2e3, 3e3);
  const Influence half{0.5};
  for (const shape::Shape& shape :
       {shape::Shape(shape::Circle{far_W, Vec3::UnitZ(), 1e-14}),
        shape::Shape(shape::Cylinder{far_W, Vec3::UnitZ(), 1e-14}), shape::Shape(shape::Sphere{far_W, 1e-14})}) {
    InfluenceState state;
    for (const double dt_s : {0.0, 1e-3, 1e-3}) {
      const Influenced found = influencedTarget(shape, half, far_W + Vec3(1, 1, 0), Vec3::UnitX(), dt_s, state);
      EXPECT_EQ(found.p_WP, far_W);
      EXPECT_TRUE(state.n_W.allFinite());
    }
  }
}

TEST(Influence, MeetsTheGoldenAngles) {
  const Value file = test::golden("influence.json");
  for (const Value& one : file.find("angles")->items) {
    const double alpha_rad = one.find("alpha")->number, beta_rad = one.find("beta")->number;
    const Influenced target = from_rest(kRing, {one.find("t")->number}, at(beta_rad, 0.06), at(alpha_rad));
    ASSERT_TRUE(target.is_unique);
    ASSERT_LE(apart(target.angles.alpha_rad, alpha_rad), 1e-15);
    ASSERT_LE(apart(target.angles.beta_rad, beta_rad), 1e-15);
    // Angles of 1 ulp, and a delta near a half turn that rounds to the other side would be 2 pi t away: none is so
    // near.
    ASSERT_LE(apart(target.angles.theta_rad, one.find("theta")->number), 3e-15) << one.line;
  }
}

TEST(Influence, MeetsTheGoldenCirclesInEveryOrientation) {
  const Value file = test::golden("influence.json");
  int compared = 0;
  for (const Value& one : file.find("circle3d")->items) {
    const shape::Circle circle =
        shape::makeCircle(kMetrePerMillimetre * threeOf(*one.find("center")), threeOf(*one.find("axis")),
                          kMetrePerMillimetre * one.find("radius")->number, {})
            .value();
    const Influenced target = from_rest(circle, {one.find("t")->number}, kMetrePerMillimetre * threeOf(*one.find("P")),
                                        threeOf(*one.find("stylus_z")));
    if (one.find("Q")->kind == json::JsonKind::Null) {
      EXPECT_FALSE(target.is_unique);
      continue;
    }
    ++compared;
    ASSERT_TRUE(target.is_unique) << one.line;
    // mm; the stylus's z is a unit vector to 1e-16, coordinates are of some 100 mm.
    ASSERT_LE((kMillimetrePerMetre * target.p_WP - threeOf(*one.find("Q"))).norm(), 1e-11) << one.line;
  }
  EXPECT_GT(compared, 35);
}

TEST(Influence, MeetsTheGoldenSpheres) {
  const Value file = test::golden("influence.json");
  for (const Value& one : file.find("sphere_slerp")->items) {
    const shape::Sphere sphere = shape::makeSphere(kMetrePerMillimetre * threeOf(*one.find("center")),
                                                   kMetrePerMillimetre * one.find("radius")->number, {})
                                     .value();
    const Influenced target = from_rest(sphere, {one.find("t")->number}, kMetrePerMillimetre * threeOf(*one.find("P")),
                                        threeOf(*one.find("stylus_z")));
    ASSERT_LE((kMillimetrePerMetre * target.p_WP - threeOf(*one.find("Q"))).norm(), 1e-11) << one.line;
    ASSERT_NEAR(target.angles.beta_rad, one.find("angle")->number, 1e-14);
  }
}

TEST(Influence, WithPositionAloneItIsTheNearestPoint) {
  test::Random random(test::Seed{20070501});
  for (int i = 0; i < test::sweep(2'000, 100'000); ++i) {
    const Vec3 p_WT = random.inBox(0.1), stylus_W = random.direction();
    for (const shape::Shape& shape : {shape::Shape(kTilted), shape::Shape(kTube), shape::Shape(kBall)}) {
      const shape::Nearest nearest = closestPoint(shape, p_WT);
      const Influenced target = from_rest(shape, {1.0, 1.0, 0.1}, p_WT, stylus_W);
      ASSERT_LE((target.p_WP - nearest.p_WP).norm(), 1e-15) << i;
      ASSERT_NEAR(target.distance_m, std::abs(nearest.height_m), 1e-15);
    }
  }
}

TEST(Influence, TheTargetIsOnTheShapeAndTurnsWithTheStylusWhenOrientationAloneCounts) {
  test::Random random(test::Seed{20070502});
  for (int i = 0; i < test::sweep(2'000, 100'000); ++i) {
    const Vec3 p_WT = random.inBox(0.1), stylus_W = random.direction();
    for (const double t : {0.0, 0.3, 1.0}) {
      const Vec3 on_ring = from_rest(kTilted, {t}, p_WT, stylus_W).p_WP - kTilted.p_WC;
      ASSERT_NEAR(on_ring.norm(), 0.04, 1e-15);
      ASSERT_NEAR(on_ring.dot(kTilted.axis_W), 0.0, 1e-16);
      ASSERT_NEAR((from_rest(kBall, {t}, p_WT, stylus_W).p_WP - kBall.p_WC).norm(), 0.05, 1e-15);
    }
    const Vec3 onto_W = stylus_W - stylus_W.dot(kTilted.axis_W) * kTilted.axis_W;
    if (onto_W.norm() < 0.01) continue;
    const Vec3 wanted = kTilted.p_WC + 0.04 * onto_W.normalized();
    ASSERT_LE((from_rest(kTilted, {0.0}, p_WT, stylus_W).p_WP - wanted).norm(), 1e-14);
    const Vec3 other = from_rest(kTilted, {0.0, -1.0}, p_WT, stylus_W).p_WP;  // -z of frame 6: the other side
    ASSERT_LE((other - (2.0 * kTilted.p_WC - wanted)).norm(), 1e-14);
  }
}

TEST(Influence, TheTargetLiesOnTheArcFromTheOrientationToThePositionNearestPoint) {
  test::Random random(test::Seed{20070504});
  for (int i = 0; i < test::sweep(2'000, 100'000); ++i) {
    const Vec3 p_WT = random.inBox(0.1), stylus_W = random.direction();
    const Influence influence{random.between(0.0, 1.0), i % 2 == 0 ? 1.0 : -1.0, i % 3 == 0 ? 0.5 : 0.0};
    for (const shape::Shape& shape : {shape::Shape(kTilted), shape::Shape(kTube), shape::Shape(kBall)}) {
      const Influenced target = from_rest(shape, influence, p_WT, stylus_W);
      const Arc& arc = target.arc;
      const auto alongArc = [&](double share) {
        return Vec3(arc.p_WC + Eigen::AngleAxisd(share * arc.turn_rad, arc.axis_W) * (arc.p_WPo - arc.p_WC));
      };
      ASSERT_LE((alongArc(1.0) - arc.p_WPp).norm(), 1e-14) << i;
      ASSERT_LE((alongArc(arc.share) - target.p_WP).norm(), 1e-14) << i;
      ASSERT_LE((arc.p_WPp - closestPoint(shape, p_WT).p_WP).norm(), 1e-14) << i;
      ASSERT_GE(arc.share, influence.t - 1e-15);
      ASSERT_LE(arc.share, 1.0);
      Influence orientation_alone = influence;
      orientation_alone.t = orientation_alone.blend_rad = 0.0;
      ASSERT_LE((from_rest(shape, orientation_alone, p_WT, stylus_W).p_WP - arc.p_WPo).norm(), 1e-14) << i;
    }
  }
}

TEST(Influence, AnArcWithOneEndHasNoTurn) {
  const Arc on_axis = from_rest(kRing, {0.5}, {0, 0, 0.01}, at(1.0)).arc;
  EXPECT_EQ(on_axis.turn_rad, 0.0);
  EXPECT_LE((on_axis.p_WPo - at(1.0, 0.05)).norm(), 1e-17);
  EXPECT_FALSE(on_axis.p_WPp.allFinite());
  const Arc along_axis = from_rest(kRing, {0.5}, at(2.0, 0.06), Vec3::UnitZ()).arc;
  EXPECT_EQ(along_axis.turn_rad, 0.0);
  EXPECT_FALSE(along_axis.p_WPo.allFinite());
  EXPECT_LE((along_axis.p_WPp - at(2.0, 0.05)).norm(), 1e-17);
  const Arc in_centre = from_rest(kBall, {0.5}, kBall.p_WC, at(1.0)).arc;
  EXPECT_EQ(in_centre.axis_W, Vec3::Zero());
  EXPECT_FALSE(in_centre.p_WPp.allFinite());
}

TEST(Influence, WhereTheStylusIsAlongTheAxisThePositionTakesOverWithoutAStep) {
  const Vec3 p_WT = at(0.4, 0.06);
  const Influence influence{0.2, 1.0, 5.0 * kRadPerDegree};
  Vec3 last = from_rest(kRing, influence, p_WT, {0, 0, 1}).p_WP;
  EXPECT_LE((last - at(0.4, 0.05)).norm(), 1e-16);  // position alone
  double longest_m = 0.0;
  for (double lean_deg = 0.01; lean_deg < 10.0; lean_deg += 0.01) {
    const double lean_rad = lean_deg * kRadPerDegree;
    const Vec3 stylus_W(std::sin(lean_rad) * std::cos(2.0), std::sin(lean_rad) * std::sin(2.0), std::cos(lean_rad));
    const Vec3 now = from_rest(kRing, influence, p_WT, stylus_W).p_WP;
    longest_m = std::max(longest_m, (now - last).norm());
    last = now;
  }
  // Steps of 0.01 of 5 degrees, the slope of the blend at most 1.5, over an arc of (1 - t) 1.6 rad at 50 mm.
  EXPECT_LE(longest_m, 0.01 / 5.0 * 1.5 * 0.8 * 1.6 * 0.05 * 1.001);
  EXPECT_LE((last - at(2.0 + 0.2 * (0.4 - 2.0), 0.05)).norm(), 1e-15);  // beyond the blend: the plain formula
  const Influence without{0.2, 1.0, 0.0};
  EXPECT_LE((from_rest(kRing, without, p_WT, {0, 0, 1}).p_WP - at(0.4, 0.05)).norm(), 1e-16);
}

TEST(Influence, OnTheAxisTheStylusAloneSaysWhereAndWithoutItNothingDoes) {
  const Influenced turned = from_rest(kRing, {0.7}, {0, 0, 0.02}, at(1.1));
  EXPECT_TRUE(turned.is_unique);
  EXPECT_LE((turned.p_WP - at(1.1, 0.05)).norm(), 1e-16);
  const Influenced neither = from_rest(kRing, {0.7}, {0, 0, 0.02}, {0, 0, -1});
  EXPECT_FALSE(neither.is_unique);
  EXPECT_EQ(neither.p_WP, Vec3(0, 0, 0.02));
  EXPECT_LE((from_rest(kBall, {0.7}, kBall.p_WC, {0, 0, 1}).p_WP - (kBall.p_WC + Vec3(0, 0, 0.05))).norm(), 1e-16);
}

TEST(Influence, ATrembleAboutHalfATurnDoesNotThrowTheTargetAcross) {
  test::Random random(test::Seed{20070503});
  InfluenceState state;
  Vec3 last = influencedTarget(kRing, {0.5}, at(kPi - 0.05, 0.06), at(0.0), 0.0, state).p_WP;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 now =
        influencedTarget(kRing, {0.5}, at(kPi + random.between(-0.1, 0.1), 0.06), at(0.0), 0.0, state).p_WP;
    ASSERT_LE((now - last).norm(), 0.05 * 0.5 * 0.2 * 1.001) << i;  // as far as half of the tremble
    last = now;
  }
  EXPECT_GT(last.y(), 0.04);  // still on the side where it began
  last = influencedTarget(kRing, {0.5}, at(kPi + 0.3, 0.06), at(0.0), 0.0, state).p_WP;
  EXPECT_LT(last.y(), -0.04);  // well beyond, the shorter way is the other one
}

TEST(Influence, OppositeTheStylusATrembleMovesTheTargetOnASphereNoFurtherThanItself) {
  test::Random random(test::Seed{20070505});
  InfluenceState state;
  const auto tip = [](double x, double y) { return Vec3(kBall.p_WC + 0.06 * Vec3(x, y, 1.0).normalized()); };
  influencedTarget(kBall, {0.5}, tip(0.5, 0.0), {0, 0, -1}, 0.0, state);  // it comes to the tie from x
  Vec3 last = influencedTarget(kBall, {0.5}, tip(0.02, 0.0), {0, 0, -1}, 0.0, state).p_WP;
  EXPECT_GT(last.x() - kBall.p_WC.x(), 0.049);
  for (int i = 0; i < 5000; ++i) {
    const double x = random.between(-0.02, 0.02), y = random.between(-0.02, 0.02);
    const Vec3 now = influencedTarget(kBall, {0.5}, tip(x, y), {0, 0, -1}, 0.0, state).p_WP;
    ASSERT_LE((now - last).norm(), 0.05 * 0.15) << i;  // with the plain normal it is up to 0.1 m
    last = now;
  }
  last = influencedTarget(kBall, {0.5}, tip(-0.3, 0.0), {0, 0, -1}, 0.0, state).p_WP;
  EXPECT_LT(last.x() - kBall.p_WC.x(), -0.04);  // well beyond, the shorter way is the other one
}

TEST(Influence, TheTargetGoesRoundNoFasterThanItsSlew) {
  test::Random random(test::Seed{20070506});
  for (const shape::Shape& shape : {shape::Shape(kTilted), shape::Shape(kTube), shape::Shape(kBall)}) {
    InfluenceState state;
    Vec3 last_W = Vec3::Zero();
    for (int i = 0; i < test::sweep(3'000, 100'000); ++i) {  // a hand that is everywhere at once
      const Vec3 p_WT = random.inBox(0.1);
      const Influenced now = influencedTarget(shape, {0.5, 1.0, 0.1}, p_WT, random.direction(), 1e-3, state);
      ASSERT_TRUE(now.is_unique && now.p_WP.allFinite());
      const Vec3 n_W = (now.p_WP - now.arc.p_WC).normalized();
      const double radius_m = (now.p_WP - now.arc.p_WC).norm();
      if (i > 0) {
        ASSERT_LE(radius_m * std::atan2(n_W.cross(last_W).norm(), n_W.dot(last_W)), 2e-3 * (1.0 + 1e-9));
      }
      last_W = n_W;
    }
    // Held still it arrives, within the half circle's time.
    Influenced now;
    for (int i = 0; i < 90; ++i) now = influencedTarget(shape, {0.5}, {0.05, 0.06, 0.07}, Vec3::UnitX(), 1e-3, state);
    EXPECT_LE((now.p_WP - from_rest(shape, {0.5}, {0.05, 0.06, 0.07}, Vec3::UnitX()).p_WP).norm(), 1e-15);
  }
}

TEST(Influence, TiesAreFiniteAndOneOfTheTwo) {
  const Value file = test::golden("influence.json");
  for (const Value& one : file.find("ties")->items) {
    const Influenced target =
        from_rest(kRing, {one.find("t")->number}, at(one.find("beta")->number, 0.06), at(one.find("alpha")->number));
    double nearest_rad = kInfinity;
    for (const Value& accepted : one.find("accept")->items) {
      nearest_rad = std::min(nearest_rad, apart(target.angles.theta_rad, accepted.number));
    }
    EXPECT_LE(nearest_rad, 1e-15);
  }
  EXPECT_TRUE(from_rest(kBall, {0.5}, kBall.p_WC + Vec3(0, 0, 0.06), {0, 0, -1}).p_WP.allFinite());
}

TEST(Influence, EverythingFiniteGivesSomethingFinite) {
  test::Random random(test::Seed{20070504});
  for (int i = 0; i < test::sweep(20'000, 100'000); ++i) {
    InfluenceState state;
    const double scale = std::pow(10.0, random.between(-18, 1));
    Vec3 stylus_W = random.direction();
    if (i % 3 == 0) stylus_W = (kTilted.axis_W + scale * random.direction()).normalized();
    const Vec3 p_WT = kTilted.p_WC + scale * random.inBox(1.0);
    for (const shape::Shape& shape : {shape::Shape(kTilted), shape::Shape(kTube), shape::Shape(kBall)}) {
      const Influenced target =
          influencedTarget(shape, {random.between(0, 1), 1.0, random.between(0, 0.5)}, p_WT, stylus_W, 0.0, state);
      ASSERT_TRUE(target.p_WP.allFinite());
    }
  }
}

}  // namespace underact::target
