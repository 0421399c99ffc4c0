#include "core/curve/nearest.h"

#include "core/curve/along.h"
#include "tests/core/curve/oracle.h"

namespace underact::curve {
namespace {

using test::Random;
using test::Seed;

Nearest nearestOf(const Curve& curve, const Vec3& p_WT, Search search = Search::Global) {
  SearchState state;
  return nearestPoint(curve, search, p_WT, state);
}

/// What all that is found has to be, however it was found.
void expectSound(const Curve& curve, const Nearest& nearest, const Vec3& p_WT, double scale_m) {
  ASSERT_TRUE(nearest.p_WP.allFinite() && nearest.tangent_W.allFinite());
  ASSERT_NEAR(nearest.tangent_W.norm(), 1.0, 1e-14);
  ASSERT_NEAR(nearest.distance_m, (nearest.p_WP - p_WT).norm(), 1e-15 * scale_m + 1e-15 * nearest.distance_m);
  ASSERT_LE((pointOn(curve, nearest.piece, nearest.u) - nearest.p_WP).norm(), 0.0);
  ASSERT_LE((pointAt(curve, nearest.s_m) - nearest.p_WP).norm(), 4e-15 * scale_m);
  ASSERT_LE(nearest.visits, kMaxVisits);
}

TEST(CurveNearest, IsTheFootOfACornerWorkedByHand) {
  const auto corner = curveOf({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, CurveKind::Polyline);
  const Nearest on_first = nearestOf(*corner, {1, -2, 0});
  EXPECT_EQ(on_first.p_WP, Vec3(1, 0, 0));
  EXPECT_EQ(on_first.distance_m, 2.0);
  EXPECT_EQ(on_first.s_m, 1.0);
  EXPECT_EQ(on_first.tangent_W, Vec3(1, 0, 0));
  EXPECT_TRUE(on_first.is_proved && on_first.is_unique);
  EXPECT_EQ(nearestOf(*corner, {5, -1, 2}).p_WP, Vec3(4, 0, 0));  // beyond the corner
  EXPECT_EQ(nearestOf(*corner, {5, -1, 2}).s_m, 4.0);
  EXPECT_EQ(nearestOf(*corner, {4, 9, 0}).p_WP, Vec3(4, 3, 0));  // beyond the end
  EXPECT_EQ(nearestOf(*corner, {4, 9, 0}).s_m, 7.0);
  EXPECT_EQ(nearestOf(*corner, {-1, 0, 0}).s_m, 0.0);
  const Nearest bisector = nearestOf(*corner, {3, 1, 0});  // as near to both sides, 90 degrees apart
  EXPECT_FALSE(bisector.is_unique);
  EXPECT_EQ(bisector.distance_m, 1.0);
}

TEST(CurveNearest, OnAParabolaIsWhatItsCubicEquationSays) {
  // The tangents of a cubic with controls (0, 0), (1/3, 0), (2/3, 1/3), (1, 1) make it y = x^2, x = u. A spline cannot
  // be told its controls, so a curve is put together.
  Curve parabola;
  parabola.kind = CurveKind::Spline;
  parabola.controls_W = {{0, 0, 0}, {1.0 / 3, 0, 0}, {2.0 / 3, 1.0 / 3, 0}, {1, 1, 0}};
  parabola.s_m = {0.0, 1.4789428575445974};  // sqrt(5) / 2 + asinh(2) / 4
  parabola.largest_m = 1.0;
  parabola.boxes = makeBoxes(parabola.controls_W, 3);
  // The foot of (X, Y) is the root of 2 x^3 + (1 - 2 Y) x - X. For x = 1/2: X = 1/4 + 1/2 (1 - 2 Y).
  const Nearest half = nearestOf(parabola, {0.75, 0.0, 0.0});
  EXPECT_NEAR(half.u, 0.5, 1e-15);
  EXPECT_LT((half.p_WP - Vec3(0.5, 0.25, 0)).norm(), 1e-15);
  EXPECT_LT((half.tangent_W - Vec3(1, 1, 0) / std::sqrt(2.0)).norm(), 1e-15);
  // s(1/2) = sqrt(2) / 4 + asinh(1) / 4, here by one quadrature of eight points, whose error is 1e-9 on such a piece.
  EXPECT_NEAR(half.s_m, 0.25 * (std::sqrt(2.0) + std::asinh(1.0)), 1e-9);
  // The centre of curvature at x = 0 is (0, 1/2): three roots in one, and still 0 is found.
  EXPECT_NEAR(nearestOf(parabola, {0, 0.5, 0}).p_WP.norm(), 0.0, 1e-4);
  EXPECT_NEAR(nearestOf(parabola, {0, 0.5, 0}).distance_m, 0.5, 1e-15);
}

void sweepAgainstOracle(CurveKind kind, int draws, double relative, std::uint64_t seed) {
  Random random(Seed{seed});
  for (int draw = 0; draw < draws; ++draw) {
    const bool closed = draw % 2 == 1;
    const std::vector<Vec3> points_W = randomPath(random, 3 + static_cast<int>(random.below(40)), 0.01);
    const Oracle oracle(points_W, kind, closed);
    const auto curve = curveOf(points_W, kind, closed);
    for (int k = 0; k < 20; ++k) {
      Vec3 p_WT = random.inBox(0.15);
      if (k % 2 == 0) {  // beside the curve, and on it
        const double off_m = k % 4 == 0 ? 0.0 : std::pow(10.0, random.between(-8, -2));
        p_WT = pointAt(*curve, random.between(0, lengthOf(*curve))) + off_m * random.direction();
      }
      const Nearest nearest = nearestOf(*curve, p_WT);
      const auto truth_m = static_cast<double>(oracle.distance(p_WT, 48));
      expectSound(*curve, nearest, p_WT, 0.3);
      ASSERT_TRUE(nearest.is_proved);
      // The oracle is never too small, and the point found is of the curve; so both ways.
      ASSERT_NEAR(nearest.distance_m, truth_m, relative * 0.3) << "draw " << draw << ", tip " << p_WT.transpose();
    }
  }
}

// Relative to coordinates of 0.3 m: within 2^-49 for lines; for cubics kRounding, 2^-43, and what the controls are off.
TEST(CurveNearest, OfAPolylineIsTheLeastOfAll) {
  sweepAgainstOracle(CurveKind::Polyline, test::sweep(200, 20'000), 0x1p-49, 20070601);
}
TEST(CurveNearest, OfASplineIsTheLeastOfAll) {
  sweepAgainstOracle(CurveKind::Spline, test::sweep(40, 2000), 0x1p-43, 20070602);
}

TEST(CurveNearest, TheErrorIsAcrossASpline) {  // a step along it changes the distance in second order only
  Random random(Seed{20070603});
  for (int draw = 0; draw < test::sweep(2000, 100'000); ++draw) {
    const auto curve = curveOf(randomPath(random, 8, 0.01), CurveKind::Spline, draw % 2 == 1);
    const Vec3 p_WT = pointAt(*curve, random.between(0, lengthOf(*curve))) + 1e-3 * random.direction();
    const Nearest nearest = nearestOf(*curve, p_WT);
    const bool at_end = !curve->is_closed && (nearest.s_m == 0.0 || nearest.s_m == lengthOf(*curve));
    // Rounding of coordinates of 0.2 m; at a knot the tangents of both sides differ by 1e-11 of the 1e-3 m.
    if (!at_end) {
      ASSERT_LT(std::abs((p_WT - nearest.p_WP).dot(nearest.tangent_W)), 1e-14);
    }
  }
}

TEST(CurveNearest, HoldsInEveryUnitAndFarFromTheOrigin) {
  Random random(Seed{20070604});
  for (const double scale : {1e-9, 1e-6, 1e-3, 1.0, 1e3}) {
    for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
      std::vector<Vec3> points_W = randomPath(random, 20, 0.1);
      double largest = 0.0;
      for (const Vec3& p_W : points_W) largest = std::max(largest, p_W.cwiseAbs().maxCoeff());
      for (Vec3& p_W : points_W) p_W *= scale / largest;
      for (const Vec3& shift_W : {Vec3(0, 0, 0), Vec3(-999, 500, 999)}) {
        if (scale > 1.0 && shift_W.norm() > 0.0) continue;
        std::vector<Vec3> there_W = points_W;
        for (Vec3& p_W : there_W) p_W = 0.5 * p_W + shift_W;
        if (scale < 1e-6 && shift_W.norm() > 0.0) continue;  // kSamePoint and the rounding at 1 km are above it
        const auto made = makeCurve(there_W, kind, false);
        ASSERT_TRUE(made);
        const Oracle oracle(there_W, kind, false);
        for (int k = 0; k < 20; ++k) {
          const Vec3 p_WT = random.inBox(scale) + shift_W;
          const Nearest nearest = nearestOf(*made.value(), p_WT);
          // A point left out as the same is off by kSamePoint_m, and turns the handles of its neighbours, which are
          // some times as long.
          const double allowed_m = std::max(0x1p-43 * (scale + shift_W.norm()), 10 * kSamePoint_m);
          ASSERT_NEAR(nearest.distance_m, static_cast<double>(oracle.distance(p_WT, 48)), allowed_m) << scale;
        }
      }
    }
  }
}

TEST(CurveNearest, OfTwoPointsOfAnyLengthIsTheFoot) {
  for (const double length_m : {2e-12, 1e-9, 1e-3, 1.0, 1e3}) {
    for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
      const auto curve = curveOf({{0, 0, 0}, {length_m, 0, 0}}, kind);
      const Nearest nearest = nearestOf(*curve, {0.25 * length_m, 0.5 * length_m, 0});
      EXPECT_LT((nearest.p_WP - Vec3(0.25 * length_m, 0, 0)).norm(), 1e-15 * length_m);
      EXPECT_TRUE(nearest.is_proved && nearest.is_unique);
    }
  }
}

TEST(CurveNearest, BetweenTwoEqualBranchesIsNotUniqueAndTheLastStays) {
  // A hairpin, 4 mm wide; its middle line is as near to both sides.
  const std::vector<Vec3> points_W{{0, 0.002, 0},     {0.02, 0.002, 0},  {0.04, 0.002, 0},
                                   {0.04, -0.002, 0}, {0.02, -0.002, 0}, {0, -0.002, 0}};
  for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
    const auto curve = curveOf(points_W, kind);
    const Vec3 p_WT(0.01, 0, 0);
    EXPECT_FALSE(nearestOf(*curve, p_WT).is_unique);
    EXPECT_TRUE(nearestOf(*curve, p_WT + Vec3(0, 1e-12, 0)).is_unique);
    for (const double side : {1.0, -1.0}) {
      SearchState state;
      nearestPoint(*curve, Search::Hybrid, {0.01, side * 0.002, 0}, state);
      const Nearest nearest = nearestPoint(*curve, Search::Hybrid, p_WT, state);
      EXPECT_EQ(nearest.p_WP.y() > 0.0, side > 0.0);
      EXPECT_TRUE(nearest.is_proved && !nearest.is_unique);
    }
  }
}

TEST(CurveNearest, OnACrossingIsUnique) {  // both branches pull to the same point: nowhere
  const auto cross = curveOf({{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, CurveKind::Polyline);
  EXPECT_TRUE(nearestOf(*cross, {0, 0, 0}).is_unique);
  EXPECT_EQ(nearestOf(*cross, {0, 0, 0}).distance_m, 0.0);
  EXPECT_FALSE(nearestOf(*cross, {0.125, -0.125, 0}).is_unique);
}

TEST(CurveNearest, WhereOneCubicHasTwoEqualMinimaBothAreSeen) {
  const auto arch = curveOf({{-0.03, -0.05, 0}, {-0.02, 0, 0}, {0.02, 0, 0}, {0.03, -0.05, 0}}, CurveKind::Spline);
  int seen = 0;
  for (double y_m = -0.05; y_m < 0.02; y_m += 0.001) {  // along the axis of symmetry
    const Nearest nearest = nearestOf(*arch, {0, y_m, 0});
    const Nearest mirrored = nearestOf(*arch, {0, y_m, 0}, Search::Hybrid);
    EXPECT_NEAR(nearest.distance_m, mirrored.distance_m, 1e-16);
    EXPECT_EQ(nearest.is_unique, std::abs(nearest.p_WP.x()) < 1e-7) << y_m;
    seen += nearest.is_unique ? 0 : 1;
  }
  EXPECT_GT(seen, 5);
}

TEST(CurveNearest, OfAMillionPointsIsTheLeastOfAll) {
  Random random(Seed{20070606});
  for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
    const int count = kind == CurveKind::Spline ? 100'000 : 1'000'000;  // a spline of a million takes seconds to make
    const std::vector<Vec3> points_W = randomPath(random, count, 1e-4);
    const auto curve = curveOf(points_W, kind);
    const Oracle oracle(points_W, CurveKind::Polyline, false);
    for (int k = 0; k < 5; ++k) {
      const Vec3 p_WT = pointAt(*curve, random.between(0, lengthOf(*curve))) + 1e-3 * random.direction();
      const Nearest nearest = nearestOf(*curve, p_WT);
      ASSERT_TRUE(nearest.is_proved);
      // The lines of 0.2 mm at most are the oracle of the spline, too: it is within half a chord of them (spline.h).
      const double allowed_m = kind == CurveKind::Spline ? 1e-4 : 0x1p-49 * curve->largest_m;
      ASSERT_NEAR(nearest.distance_m, static_cast<double>(oracle.distance(p_WT, 1)), allowed_m);
    }
  }
}

TEST(CurveNearest, AtTheCentreOfACircleTimeIsBounded) {
  for (const int count : {12, 1000, 100'000}) {
    for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
      std::vector<Vec3> points_W;
      for (int i = 0; i < count; ++i) {
        points_W.emplace_back(0.04 * std::cos(2 * kPi * i / count), 0.04 * std::sin(2 * kPi * i / count), 0);
      }
      const auto curve = curveOf(points_W, kind, true);
      for (const Search search : {Search::Global, Search::Hybrid, Search::Local}) {
        const Nearest nearest = nearestOf(*curve, Vec3::Zero(), search);
        EXPECT_LE(nearest.visits, kMaxVisits);
        EXPECT_FALSE(nearest.is_unique);
        // The apothem of the polygon, or for a cubic within its distance from the circle.
        const double apothem_m = 0.04 * std::cos(kPi / count);
        if (kind == CurveKind::Polyline) {
          EXPECT_NEAR(nearest.distance_m, apothem_m, 1e-12);
        }
        if (kind == CurveKind::Spline) {
          EXPECT_NEAR(nearest.distance_m, 0.04, 0.04 * std::pow(2 * kPi / count, 4) + 1e-14);
        }
      }
    }
  }
}

TEST(CurveNearest, OfAnyFiniteTipIsFinite) {
  Random random(Seed{20070605});
  for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
    const auto curve = curveOf(randomPath(random, 30, 0.01), kind);
    for (const double size : {1e-310, 1e-200, 1e-30, 1e5, 1e7, 1e30, 1e153, 1e155, 1e200, 1.7e308}) {
      for (const Search search : {Search::Global, Search::Hybrid, Search::Local}) {
        const Vec3 p_WT = size * Vec3(-1, 0.5, 1);
        const Nearest nearest = nearestOf(*curve, p_WT, search);
        EXPECT_TRUE(nearest.p_WP.allFinite() && nearest.tangent_W.allFinite()) << size;
        EXPECT_TRUE(std::isfinite(nearest.distance_m) && std::isfinite(nearest.s_m)) << size;
        if (size > 1.0) {
          EXPECT_NEAR(nearest.distance_m / std::min(1.5 * size, 1.7976931348623157e308), 1.0, 1e-4) << size;
        }
      }
    }
    SearchState state{5};
    const Nearest none = nearestPoint(*curve, Search::Hybrid, {0, kInfinity, kNotANumber}, state);
    EXPECT_TRUE(none.p_WP.allFinite() && !none.is_proved && !none.is_unique);
    EXPECT_EQ(state.piece, 5);
  }
}

TEST(CurveNearest, AStateOfAnotherCurveIsAsGoodAsNone) {
  const auto curve = curveOf({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, CurveKind::Polyline);
  for (const std::int32_t piece : {-5, 2, 1'000'000}) {
    SearchState state{piece};
    EXPECT_EQ(nearestPoint(*curve, Search::Local, {1, -2, 0}, state).p_WP, Vec3(1, 0, 0));
    EXPECT_EQ(state.piece, 0);
  }
}

}  // namespace
}  // namespace underact::curve
