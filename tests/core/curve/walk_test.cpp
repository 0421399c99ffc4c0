#include <cstring>

#include "core/curve/along.h"
#include "core/curve/nearest.h"
#include "core/curve/points.h"
#include "tests/core/curve/oracle.h"

// The searches against each other, tick by tick along paths as a hand would go.
namespace underact::curve {
namespace {

using test::Random;
using test::Seed;

/// A hand that wanders about the curve, up to off_m away, some millimetres in a hundred ticks.
std::vector<Vec3> handPath(const Curve& curve, Random& random, double off_m, int ticks) {
  std::vector<Vec3> tips;
  double s_m = random.between(0.0, lengthOf(curve));
  Vec3 off_W = Vec3::Zero();
  double speed_m = random.between(-4e-4, 4e-4);
  for (int tick = 0; tick < ticks; ++tick) {
    if (tick % 200 == 199) speed_m = random.between(-4e-4, 4e-4);
    s_m = wrappedArcLength(curve, s_m + speed_m);
    off_W = 0.995 * off_W + 0.02 * off_m * random.inBox(1.0);
    tips.push_back(pointAt(curve, s_m) + off_W);
  }
  return tips;
}

std::vector<Vec3> scenePath(const char* name) {
  std::vector<Vec3> points = readPoints(std::string(UNDERACT_SOURCE) + "/scenes/paths/" + name).value();
  for (Vec3& p : points) p *= 1e-3;
  return points;
}

struct Case {
  std::vector<Vec3> points_W;
  bool closed;
};

std::vector<Case> cases() {
  Random random(Seed{20070610});
  return {{scenePath("trefoil.txt"), true},
          {scenePath("signature.txt"), false},
          {randomPath(random, 100, 0.004), false},
          {randomPath(random, 3000, 0.0005), true}};
}

bool sameBits(const Nearest& a, const Nearest& b) {
  return std::memcmp(a.p_WP.data(), b.p_WP.data(), sizeof(double) * 3) == 0 && a.s_m == b.s_m && a.piece == b.piece &&
         a.u == b.u && a.is_unique == b.is_unique && a.visits == b.visits;
}

TEST(CurveSearch, HybridFindsWhatGlobalFinds) {
  Random random(Seed{20070611});
  for (const Case& one : cases()) {
    for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
      const auto curve = curveOf(one.points_W, kind, one.closed);
      SearchState hybrid, global;
      int apart = 0;
      const std::vector<Vec3> tips = handPath(*curve, random, 0.01, test::sweep(4000, 100'000));
      for (const Vec3& p_WT : tips) {
        const Nearest warm = nearestPoint(*curve, Search::Hybrid, p_WT, hybrid);
        const Nearest cold = nearestPoint(*curve, Search::Global, p_WT, global);
        ASSERT_TRUE(warm.is_proved && cold.is_proved);
        ASSERT_NEAR(warm.distance_m, cold.distance_m, 1e-15);  // both are exact within rounding
        if ((warm.p_WP - cold.p_WP).norm() > 1e-7) ++apart;    // a tie, or a flat minimum
      }
      EXPECT_LE(apart, static_cast<int>(tips.size()) / 1000);
    }
  }
}

TEST(CurveSearch, LocalFollowsTheBranchThatItIsOnAndIsTheLeastThere) {
  Random random(Seed{20070612});
  for (const Case& one : cases()) {
    for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
      const auto curve = curveOf(one.points_W, kind, one.closed);
      const bool is_tame = one.points_W.size() <= 60;  // no branches near each other but at crossings
      SearchState local, global;
      int other = 0;
      const std::vector<Vec3> tips = handPath(*curve, random, 2e-4, 4000);
      for (const Vec3& p_WT : tips) {
        const Nearest walked = nearestPoint(*curve, Search::Local, p_WT, local);
        const Nearest min = nearestPoint(*curve, Search::Global, p_WT, global);
        ASSERT_GE(walked.distance_m, min.distance_m - 1e-15);
        if (walked.distance_m > min.distance_m + 1e-12) ++other;
        // A minimum of its own neighbourhood: no better a little farther along the curve.
        for (const double step_m : {-1e-7, 1e-7}) {
          ASSERT_GE((pointAt(*curve, wrappedArcLength(*curve, walked.s_m + step_m)) - p_WT).norm(),
                    walked.distance_m - 1e-14);
        }
      }
      if (is_tame) {
        EXPECT_LT(other, static_cast<int>(tips.size()) / 20);
      }
    }
  }
}

TEST(CurveSearch, LocalStaysOnItsBranchWhereHybridChanges) {
  // A hairpin 4 mm wide; the hand leaves one side across for the other.
  const std::vector<Vec3> points_W{{0, 0.002, 0},     {0.02, 0.002, 0},  {0.04, 0.002, 0},
                                   {0.04, -0.002, 0}, {0.02, -0.002, 0}, {0, -0.002, 0}};
  for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
    const auto curve = curveOf(points_W, kind);
    SearchState local, hybrid;
    Nearest walked, proved;
    for (double y_m = 0.002; y_m >= -0.002; y_m -= 0.0001) {
      walked = nearestPoint(*curve, Search::Local, {0.01, y_m, 0}, local);
      proved = nearestPoint(*curve, Search::Hybrid, {0.01, y_m, 0}, hybrid);
    }
    EXPECT_GT(walked.p_WP.y(), 0.0019);
    EXPECT_FALSE(walked.is_proved);
    EXPECT_LT(proved.p_WP.y(), -0.0019);
  }
}

TEST(CurveSearch, LocalCatchesUpWithAFarMoveInAFewTicks) {
  std::vector<Vec3> points_W;
  for (int i = 0; i <= 2000; ++i) points_W.emplace_back(1e-5 * i, 0, 0);
  const auto curve = curveOf(points_W, CurveKind::Polyline);
  SearchState state;
  nearestPoint(*curve, Search::Local, {0, 0.001, 0}, state);
  Nearest nearest;
  int ticks = 0;
  for (; ticks < 100 && std::abs(nearest.p_WP.x() - 0.015) > 1e-12; ++ticks) {
    nearest = nearestPoint(*curve, Search::Local, {0.015, 0.001, 0}, state);
  }
  EXPECT_EQ(ticks, 1500 / kLongestWalk + 1);
}

TEST(CurveSearch, GivesTheSameBitsFromTheSameStates) {
  Random random(Seed{20070613});
  const auto curve = curveOf(scenePath("trefoil.txt"), CurveKind::Spline, true);
  const auto again = curveOf(scenePath("trefoil.txt"), CurveKind::Spline, true);
  const std::vector<Vec3> tips = handPath(*curve, random, 0.02, 2000);
  for (const Search search : {Search::Global, Search::Hybrid, Search::Local}) {
    SearchState a, b;
    for (const Vec3& p_WT : tips) {
      ASSERT_TRUE(sameBits(nearestPoint(*curve, search, p_WT, a), nearestPoint(*again, search, p_WT, b)));
    }
  }
}

TEST(CurveSearch, NeverLooksAtManyPartsOnAPathOfAHand) {
  // What makes Hybrid fit for the tick; the figures are in the bench.
  Random random(Seed{20070614});
  for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
    const auto curve = curveOf(randomPath(random, 20'000, 0.001), kind);
    SearchState state;
    int max = 0;
    for (const Vec3& p_WT : handPath(*curve, random, 0.002, 5000)) {
      max = std::max(max, nearestPoint(*curve, Search::Hybrid, p_WT, state).visits);
    }
    EXPECT_LT(max, 1000);
  }
}

}  // namespace
}  // namespace underact::curve
