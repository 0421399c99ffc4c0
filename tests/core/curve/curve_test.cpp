#include "core/curve/curve.h"

#include "core/curve/along.h"
#include "core/curve/points.h"
#include "core/curve/spline.h"
#include "tests/core/curve/oracle.h"

namespace underact::curve {
namespace {

using test::Random;
using test::Seed;

std::string sentenceOf(std::vector<Vec3> points_W, bool closed = false) {
  const auto curve = makeCurve(std::move(points_W), CurveKind::Polyline, closed, {"scene.json", 7, 0, "file"});
  if (curve) return "";
  EXPECT_EQ(curve.problems()[0].place.line, 7);
  return curve.problems()[0].sentence;
}

/// By many chords in long double; from above and below alike, the error is of second order in their number.
long double lengthByChords(const Oracle& oracle, int i, int chords) {
  long double sum = 0.0L;
  for (int k = 0; k < chords; ++k) {
    sum += (oracle.at(i, (k + 1.0L) / chords) - oracle.at(i, static_cast<long double>(k) / chords)).norm();
  }
  return sum;
}

/// Romberg's first step takes that error away: what is left is of fourth order.
long double lengthOfPiece(const Oracle& oracle, int i, int chords) {
  return (4.0L * lengthByChords(oracle, i, 2 * chords) - lengthByChords(oracle, i, chords)) / 3.0L;
}

TEST(Curve, RefusesTooFewOrInvalidPoints) {
  EXPECT_EQ(sentenceOf({}), "A curve needs at least 2 different points.");
  EXPECT_EQ(sentenceOf({{1, 2, 3}}), "A curve needs at least 2 different points.");
  EXPECT_EQ(sentenceOf({{1, 2, 3}, {1, 2, 3 + 1e-14}}), "A curve needs at least 2 different points.");
  EXPECT_EQ(sentenceOf({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, true), "A closed curve needs at least 3 different points.");
  EXPECT_EQ(sentenceOf({{0, 0, 0}, {1, kNotANumber, 0}}), "Point 2 of the curve is not a finite point.");
  EXPECT_EQ(sentenceOf({{0, 0, 0}, {1, 0, 0}, {0, -1001, 0}}),
            "Point 3 of the curve is farther than 1e6 mm from the origin; check the scale.");
  EXPECT_EQ(sentenceOf(std::vector<Vec3>(kMaxPoints + 1, Vec3::Zero())), "A curve has at most 1000000 points.");
}

TEST(Curve, LeavesRepeatedPointsOut) {
  const std::vector<Vec3> repeated{{0, 0, 0}, {0, 0, 0}, {3, 0, 0}, {3, 0, 1e-13}, {3, 4, 0}, {0, 0, 0}, {0, 0, 0}};
  for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
    const auto open = curveOf(repeated, kind, false), closed = curveOf(repeated, kind, true);
    EXPECT_EQ(open->controls_W.front(), Vec3(0, 0, 0));
    EXPECT_EQ(open->controls_W.back(), Vec3(0, 0, 0));
    EXPECT_EQ(closed->controls_W.front(), closed->controls_W.back());
  }
  EXPECT_EQ(pieceCount(*curveOf(repeated, CurveKind::Polyline, false)), 3);
  EXPECT_EQ(pieceCount(*curveOf(repeated, CurveKind::Polyline, true)), 3);
  EXPECT_EQ(lengthOf(*curveOf(repeated, CurveKind::Polyline, true)), 12.0);
}

TEST(Curve, ASplineOfPointsOnALineIsTheLine) {
  const auto curve = curveOf({{0, 0, 0}, {0.01, 0, 0}, {0.015, 0, 0}, {0.06, 0, 0}}, CurveKind::Spline);
  EXPECT_NEAR(lengthOf(*curve), 0.06, 1e-17);
  for (double s_m = 0.0; s_m <= 0.06; s_m += 0.001) EXPECT_LT((pointAt(*curve, s_m) - Vec3(s_m, 0, 0)).norm(), 1e-16);
  const auto two = curveOf({{0, 0, 0}, {0, 0.02, 0}}, CurveKind::Spline);
  EXPECT_LT((pointAt(*two, 0.013) - Vec3(0, 0.013, 0)).norm(), 1e-16);
}

TEST(Curve, AHandWorkedSplineGoesWhereItsFormulaSays) {
  // Chords of 1 along x and 4 along y, so d1 = 1, d2 = 2. The handles at the corner are (x + y) d2 d1^2 / (3 (d1 + d2))
  // = (x + y) 2/9 before it and (x + y) d1 d2^2 / (3 (d1 + d2)) = (x + y) 4/9 behind it, those at the ends a third of
  // the chord. Halfway a cubic is at (a + 3 b + 3 c + d) / 8.
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 4, 0}};
  const Vec3 first = (3 * Vec3(1.0 / 3, 0, 0) + 3 * Vec3(7.0 / 9, -2.0 / 9, 0) + Vec3(1, 0, 0)) / 8;
  const Vec3 second = (Vec3(1, 0, 0) + 3 * Vec3(13.0 / 9, 4.0 / 9, 0) + 3 * Vec3(1, 8.0 / 3, 0) + Vec3(1, 4, 0)) / 8;
  const std::vector<Vec3> controls = splineControls(points, false);
  for (const Vec3& p : {first, second}) {  // both are cut into equal halves, so they are the begin of a piece
    double nearest = kInfinity;
    for (std::size_t i = 0; i < controls.size(); i += 3) nearest = std::min(nearest, (controls[i] - p).norm());
    EXPECT_LT(nearest, 1e-15);
  }
}

TEST(Curve, ASplineIsTheOneOfBarryAndGoldman) {
  Random random(Seed{20070601});
  for (int draw = 0; draw < test::sweep(40, 1000); ++draw) {
    const bool closed = draw % 2 == 1;
    const std::vector<Vec3> points_W = randomPath(random, 12, 0.01);
    const Oracle oracle(points_W, CurveKind::Spline, closed);
    const auto curve = curveOf(points_W, CurveKind::Spline, closed);
    // Pieces are halves of halves of the oracle's, so each has a whole number of 2^-kMaxHalvings of it.
    std::int32_t piece = 0;
    for (int i = 0; i < oracle.pieces(); ++i) {
      for (long double share = 0.0L; share < 1.0L; ++piece) {
        ASSERT_LT(piece, pieceCount(*curve));
        long double width = 1.0L;
        const Vec3 end_W = pointOn(*curve, piece, 1.0);
        while (width > 0x1p-7L && (oracle.at(i, share + width).cast<double>() - end_W).norm() > 1e-13) width /= 2.0L;
        ASSERT_GT(width, 0x1p-7L);
        for (const double u : {0.0, 0.3, 0.5, 0.9, 1.0}) {
          // Knots in long double against handles in double: rounding of coordinates of 0.2 m, some ten times.
          ASSERT_LT((oracle.at(i, share + width * u).cast<double>() - pointOn(*curve, piece, u)).norm(), 1e-15);
        }
        share += width;
      }
    }
    ASSERT_EQ(piece, pieceCount(*curve));
  }
}

TEST(Curve, ATangentOfASplineNeverJumps) {
  Random random(Seed{20070602});
  for (int draw = 0; draw < test::sweep(100, 2000); ++draw) {
    const bool closed = draw % 2 == 1;
    const auto curve = curveOf(randomPath(random, 12, 0.01), CurveKind::Spline, closed);
    for (std::int32_t piece = 0; piece + 1 < pieceCount(*curve); ++piece) {
      const double jump = (tangentOn(*curve, piece, 1.0) - tangentOn(*curve, piece + 1, 0.0)).norm();
      // The difference of controls of 0.2 m, rounded to 3e-17 some times, over the handle: a third of the velocity.
      ASSERT_LT(jump * velocityOf(cubicOf(*curve, piece), 1.0).norm(), 1e-15);
    }
    if (closed) {
      EXPECT_LT((tangentOn(*curve, pieceCount(*curve) - 1, 1.0) - tangentOn(*curve, 0, 0.0)).norm(), 1e-11);
    }
  }
}

TEST(Curve, ASplineStaysWithinTwoThirdsOfEachChord) {
  // The promise of spline.h, at its worst: hairpins of very unequal chords.
  Random random(Seed{20070603});
  for (int draw = 0; draw < test::sweep(200, 5000); ++draw) {
    std::vector<Vec3> points_W{Vec3::Zero()};
    for (int i = 0; i < 8; ++i)
      points_W.push_back(points_W.back() + std::pow(10.0, random.between(-6, -1)) * random.direction());
    const Oracle oracle(points_W, CurveKind::Spline, false);
    for (int i = 0; i < oracle.pieces(); ++i) {
      const Vec3 a = points_W[static_cast<std::size_t>(i)], b = points_W[static_cast<std::size_t>(i) + 1];
      for (double share = 0.0; share <= 1.0; share += 0.05) {
        const double along =
            std::clamp((oracle.at(i, share).cast<double>() - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        // A handle has 2/3 of the chord at most, and a cubic goes 3/4 of the way to its handles.
        ASSERT_LE((oracle.at(i, share).cast<double>() - a - along * (b - a)).norm(), 0.5001 * (b - a).norm());
      }
    }
    const auto curve = curveOf(points_W, CurveKind::Spline);
    for (const Vec3& p_W : curve->controls_W) ASSERT_LT(p_W.norm(), 8.0 * 0.1 + 0.07);
  }
}

TEST(Curve, ArcLengthIsThatOfManyChords) {
  Random random(Seed{20070604});
  for (int draw = 0; draw < test::sweep(6, 100); ++draw) {
    const bool closed = draw % 2 == 1;
    const std::vector<Vec3> points_W = randomPath(random, 10, 0.01);
    const Oracle oracle(points_W, CurveKind::Spline, closed);
    long double sum = 0.0L;
    for (int i = 0; i < oracle.pieces(); ++i) sum += lengthOfPiece(oracle, i, 2000);
    // spline.h: 1e-9 of each chord; the chords' own error is some 1e-12.
    const auto curve = curveOf(points_W, CurveKind::Spline, closed);
    EXPECT_NEAR(lengthOf(*curve), static_cast<double>(sum), 1e-9 * static_cast<double>(sum));
  }
}

TEST(Curve, ArcLengthOfAHairpinIsWithinAMillionthOfAPiece) {
  for (const double off_m : {0.0, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3}) {
    const std::vector<Vec3> points_W{{0, 0, 0}, {0.05, 0, 0}, {0, off_m, 0}, {0.05, 3 * off_m, 0.001}};
    const Oracle oracle(points_W, CurveKind::Spline, false);
    long double sum = 0.0L;
    for (int i = 0; i < oracle.pieces(); ++i) sum += lengthOfPiece(oracle, i, 20000);
    const auto curve = curveOf(points_W, CurveKind::Spline);
    EXPECT_NEAR(lengthOf(*curve), static_cast<double>(sum), 1e-6 * 0.05) << off_m;
    EXPECT_LE(pieceCount(*curve), 3 * 24) << off_m;
  }
}

TEST(Curve, AnArcLengthOfACircleIsTheArc) {
  std::vector<Vec3> points_W;
  for (int i = 0; i < 500; ++i)
    points_W.emplace_back(0.04 * std::cos(i * kPi / 250), 0.04 * std::sin(i * kPi / 250), 0.01);
  // A polygon of n sides has 2 n R sin(pi / n); a cubic through the corners misses the circle by R (2 pi / n)^4 or so.
  EXPECT_NEAR(lengthOf(*curveOf(points_W, CurveKind::Polyline, true)), 1000 * 0.04 * std::sin(kPi / 500), 1e-15);
  EXPECT_NEAR(lengthOf(*curveOf(points_W, CurveKind::Spline, true)), 2 * kPi * 0.04,
              2 * kPi * 0.04 * std::pow(kPi / 250, 4));
}

TEST(Curve, ThePointAtAnArcLengthIsThere) {
  Random random(Seed{20070605});
  for (int draw = 0; draw < test::sweep(40, 1000); ++draw) {
    const CurveKind kind = draw % 2 == 0 ? CurveKind::Polyline : CurveKind::Spline;
    const bool closed = draw % 4 >= 2;
    const auto curve = curveOf(randomPath(random, 15, 0.01), kind, closed);
    EXPECT_EQ(pointAt(*curve, 0.0), curve->controls_W.front());
    EXPECT_EQ(pointAt(*curve, lengthOf(*curve)), curve->controls_W.back());
    EXPECT_EQ(pointAt(*curve, -1.0), curve->controls_W.front());
    EXPECT_EQ(pointAt(*curve, 10.0), curve->controls_W.back());
    for (int k = 0; k < 50; ++k) {
      const auto piece = static_cast<std::int32_t>(random.below(static_cast<std::size_t>(pieceCount(*curve))));
      const double u = random.between(0.0, 1.0), s_m = arcLengthAt(*curve, piece, u);
      // Sums of 0.2 m are rounded to 3e-17, some times.
      ASSERT_LT((pointAt(*curve, s_m) - pointOn(*curve, piece, u)).norm(), 1e-15);
    }
  }
}

TEST(Curve, WaysAlongAClosedOneAreTheShorterOnes) {
  const auto square = curveOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, CurveKind::Polyline, true);
  EXPECT_EQ(arcLengthBetween(*square, 0.5, 1.5), 1.0);
  EXPECT_EQ(arcLengthBetween(*square, 3.5, 0.5), 1.0);
  EXPECT_EQ(arcLengthBetween(*square, 0.5, 3.5), -1.0);
  EXPECT_EQ(wrappedArcLength(*square, 4.5), 0.5);
  EXPECT_EQ(wrappedArcLength(*square, -0.5), 3.5);
  EXPECT_EQ(wrappedArcLength(*square, 4.0), 0.0);
  const auto open = curveOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, CurveKind::Polyline);
  EXPECT_EQ(arcLengthBetween(*open, 0.5, 2.9), 2.4);
  EXPECT_EQ(wrappedArcLength(*open, 4.5), 3.0);
  EXPECT_EQ(wrappedArcLength(*open, -0.5), 0.0);
}

TEST(Curve, EveryBoxHoldsItsPieces) {
  Random random(Seed{20070606});
  for (const int count : {2, 3, 5, 6, 17, 65, 300}) {
    for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
      std::vector<Vec3> points_W = randomPath(random, count, 0.01);
      for (Vec3& p_W : points_W) p_W += Vec3(900, -700, 0);  // where floats alone would be off by 0.03 mm
      const auto curve = curveOf(points_W, kind);
      const Boxes& boxes = curve->boxes;
      ASSERT_EQ(boxes.counts[static_cast<std::size_t>(boxes.levels)], pieceCount(*curve));
      ASSERT_EQ(boxes.counts[0], 1);
      for (std::int32_t piece = 0; piece < pieceCount(*curve); ++piece) {
        const Vec3 p_O = pointOn(*curve, piece, random.between(0, 1)) - boxes.p_WO;
        std::int32_t index = piece;
        for (int level = boxes.levels - 1; level >= 0; --level, index /= 4) {
          const auto at = static_cast<std::size_t>(boxes.begins[static_cast<std::size_t>(level)] + index / 4);
          // The point is rounded to 1e-13 m up here.
          ASSERT_LE(squaredDistances(boxes.nodes[at], p_O)[static_cast<std::size_t>(index % 4)], 1e-25);
        }
      }
    }
  }
}

TEST(Curve, OfAMillionPointsIsMadeAndIsNoLargerThanItHasToBe) {
  Random random(Seed{20070607});
  std::vector<Vec3> points_W;
  for (std::size_t i = 0; i < kMaxPoints; ++i) points_W.push_back(random.inBox(0.1));  // the worst: all turns sharp
  const auto polyline = curveOf(points_W, CurveKind::Polyline);
  EXPECT_EQ(pieceCount(*polyline), 999'999);
  EXPECT_LT(bytesOf(*polyline), 70'000'000U);
  points_W.resize(100'000);  // a tenth says as much, and takes a tenth of the time
  const auto spline = curveOf(points_W, CurveKind::Spline);
  EXPECT_LT(pieceCount(*spline), 500'000);
  EXPECT_LT(bytesOf(*spline), 60'000'000U);
}

TEST(Curve, AMillionLengthsAddUpToTheLastDigit) {
  std::vector<Vec3> points_W;
  for (std::size_t i = 0; i < kMaxPoints; ++i) points_W.emplace_back(i % 2 == 0 ? 0.0 : 0.1, 0.0, 0.0);
  // 0.1 is 5.6e-18 more as a double; added one by one without correction a million of it are off by 1e-6.
  EXPECT_NEAR(lengthOf(*curveOf(points_W, CurveKind::Polyline)), 99999.9, 2e-11);
}

TEST(Curve, EqualPointsMakeEqualCurvesToTheBit) {
  Random random(Seed{20070608});
  const std::vector<Vec3> points_W = randomPath(random, 500, 0.003);
  const auto a = curveOf(points_W, CurveKind::Spline, true), b = curveOf(points_W, CurveKind::Spline, true);
  EXPECT_EQ(a->controls_W, b->controls_W);
  EXPECT_EQ(a->s_m, b->s_m);
}

}  // namespace
}  // namespace underact::curve
