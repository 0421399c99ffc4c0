#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/curve/guidance.h"
#include "tests/malloc/counter.h"

namespace underact::curve {
namespace {

/// Keeps a result, so that no compiler leaves out what made it.
double kept = 0.0;

std::shared_ptr<const Curve> knot(CurveKind kind) {
  std::vector<Vec3> points_W;
  for (int i = 0; i < 300; ++i) {
    const double a_rad = 2.0 * kPi * i / 300.0;
    points_W.emplace_back(0.013 * (std::sin(a_rad) + 2.0 * std::sin(2.0 * a_rad)),
                          0.013 * (std::cos(a_rad) - 2.0 * std::cos(2.0 * a_rad)), -0.015 * std::sin(3.0 * a_rad));
  }
  return makeCurve(std::move(points_W), kind, true).value();
}

}  // namespace

TEST(Curve, AllocatesFreesAndLocksNothing) {
  for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
    const std::shared_ptr<const Curve> curve = knot(kind);
    for (const Search search : {Search::Hybrid, Search::Global, Search::Local}) {
      SearchState state;
      GuidanceState guide;
      test::Watch watch;
      for (int tick = 0; tick < 1000; ++tick) {
        Vec3 p_WT(1e-4 * (tick % 311), 2e-4 * (tick % 97), 1e-4 * (tick % 53));
        if (tick % 100 == 7) p_WT = Vec3::Zero();  // where much is equally near
        if (tick % 100 == 9) p_WT = Vec3::Constant(1e300);
        if (tick % 100 == 11) p_WT[1] = kNotANumber;
        const Nearest nearest = nearestPoint(*curve, search, p_WT, state);
        kept += nearest.s_m + guidedTarget(*curve, {0.3, -0.2, 0.02}, nearest, p_WT, 1e-3, guide).p_WP.x();
      }
      EXPECT_EQ(watch.allocations(), 0);
      EXPECT_EQ(watch.frees(), 0);
      EXPECT_EQ(watch.locks(), 0);
    }
  }
}

}  // namespace underact::curve
