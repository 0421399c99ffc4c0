#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/curve/along.h"
#include "core/curve/guidance.h"
#include "tests/support/random.h"

// ns of one tick of each search, with how much was looked at, on scribbles of 100, 10 000 and 1 000 000 points in a box
// of 160 mm: along a hand that follows the curve at 0.2 m/s within some 2 mm, warm from the last tick; and at tips
// anywhere within 20 mm of the curve, each far from the last. And in the centre of a circle. Each tick is timed alone,
// the clock's own time taken off, and a tick's time is the least of all rounds: other programs only ever add to it.
namespace underact::curve {
namespace {

using Clock = std::chrono::steady_clock;
using test::Random;

constexpr int kTicks = 4000, kRounds = 5;

std::vector<Vec3> scribble(int count, double step_m) {
  Random random({20070601});
  std::vector<Vec3> points_W{Vec3::Zero()};
  Vec3 heading = random.direction();
  while (static_cast<int>(points_W.size()) < count) {
    const Vec3 home = -std::max(0.0, points_W.back().norm() / 0.08 - 0.5) * points_W.back().normalized();
    heading = (heading + std::sqrt(step_m / 0.02) * random.direction() + step_m / 0.02 * home).normalized();
    points_W.push_back(points_W.back() + step_m * heading);
  }
  return points_W;
}

std::vector<Vec3> along(const Curve& curve) {
  Random random({20070602});
  std::vector<Vec3> tips;
  Vec3 off_W = Vec3::Zero();
  double s_m = 0.5 * lengthOf(curve), heading = 1.0;
  for (int tick = 0; tick < kTicks; ++tick) {
    if (s_m + heading * 2e-4 > lengthOf(curve) || s_m + heading * 2e-4 < 0.0) heading = -heading;
    s_m += heading * 2e-4;
    off_W = 0.998 * off_W + 1e-4 * random.inBox(1.0);
    tips.push_back(pointAt(curve, s_m) + off_W);
  }
  return tips;
}

std::vector<Vec3> anywhere(const Curve& curve) {
  Random random({20070603});
  std::vector<Vec3> tips;
  for (int tick = 0; tick < kTicks; ++tick) {
    tips.push_back(pointAt(curve, random.between(0.0, lengthOf(curve))) +
                   random.between(0.0, 0.02) * random.direction());
  }
  return tips;
}

double nsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

double shareOf(std::vector<double> all, double share) {
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

double clockItself_ns() {
  std::vector<double> all;
  for (int i = 0; i < 10'000; ++i) {
    const Clock::time_point start = Clock::now();
    all.push_back(nsSince(start));
  }
  return shareOf(all, 0.5);
}

/// kept: so that no compiler leaves out what is timed.
template <class Tick>
void measure(const std::string& what, const std::vector<Vec3>& tips, Tick tick, double& kept) {
  const double clock_ns = clockItself_ns();
  std::vector<double> ns(tips.size(), kInfinity), visits(tips.size());
  for (int round = 0; round < kRounds; ++round) {
    SearchState search;
    GuidanceState guide;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const Clock::time_point start = Clock::now();
      const Nearest nearest = tick(tips[i], search, guide);
      const double taken_ns = nsSince(start) - clock_ns;
      kept += nearest.distance_m;
      visits[i] = nearest.visits;
      if (i > 0) ns[i] = std::min(ns[i], taken_ns);  // the first is cold
    }
  }
  ns.erase(ns.begin());
  std::printf("%-44s %8.0f %8.0f %8.0f %8.0f %8.0f\n", what.c_str(), shareOf(ns, 0.5), shareOf(ns, 0.99),
              shareOf(ns, 1.0), shareOf(visits, 0.5), shareOf(visits, 1.0));
}

void measureCurve(const std::string& name, const Curve& curve, double& kept) {
  struct Named {
    const char* name;
    Search search;
  };
  const std::vector<Vec3> followed = along(curve), others = anywhere(curve);
  for (const Named& one : {Named{"hybrid", Search::Hybrid}, {"global", Search::Global}, {"local", Search::Local}}) {
    const auto search = [&](const Vec3& p_WT, SearchState& state, GuidanceState&) {
      return nearestPoint(curve, one.search, p_WT, state);
    };
    measure(name + " along " + one.name, followed, search, kept);
    if (one.search != Search::Local) measure(name + " anywhere " + one.name, others, search, kept);
  }
  const auto guided = [&](const Vec3& p_WT, SearchState& state, GuidanceState& guide) {
    const Nearest nearest = nearestPoint(curve, Search::Hybrid, p_WT, state);
    kept += guidedTarget(curve, {0.3, 0.1, 0.01}, nearest, p_WT, 1e-3, guide).s_m;
    return nearest;
  };
  measure(name + " along hybrid, guided", followed, guided, kept);
}

/// The worst there is: everything is equally near, to the rounding.
void measureCentre(CurveKind kind, double& kept) {
  std::vector<Vec3> points_W;
  for (int i = 0; i < 100'000; ++i) {
    const double a_rad = 2e-5 * kPi * i;
    points_W.emplace_back(0.04 * std::cos(a_rad), 0.04 * std::sin(a_rad), 0.0);
  }
  const std::shared_ptr<const Curve> curve = makeCurve(std::move(points_W), kind, true).value();
  const auto search = [&](const Vec3& p_WT, SearchState& state, GuidanceState&) {
    return nearestPoint(*curve, Search::Hybrid, p_WT, state);
  };
  measure(kind == CurveKind::Spline ? "centre of a spline 100000" : "centre of a polyline 100000",
          std::vector<Vec3>(200, Vec3::Zero()), search, kept);
}

void all() {
  struct Size {
    int count;
    double step_m;
  };
  double kept = 0.0;
  std::printf("%-44s %8s %8s %8s %8s %8s\n", "ns a tick", "median", "p99", "most", "visits", "most");
  for (const Size& size : {Size{100, 4e-3}, {10'000, 1e-3}, {1'000'000, 2e-4}}) {
    for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
      const std::shared_ptr<const Curve> curve = makeCurve(scribble(size.count, size.step_m), kind, false).value();
      const std::string name = kind == CurveKind::Polyline ? "polyline" : "spline";
      measureCurve(name + " " + std::to_string(pieceCount(*curve)), *curve, kept);
    }
  }
  for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) measureCentre(kind, kept);
  if (kept == 0.0) std::printf("\n");
}

}  // namespace
}  // namespace underact::curve

int main() {
  underact::curve::all();
}
