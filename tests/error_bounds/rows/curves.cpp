#include <array>
#include <memory>

#include "core/base/norms.h"
#include "core/curve/nearest.h"
#include "tests/error_bounds/oracle/shapes.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace curves_rows {

struct Drawn {
  std::shared_ptr<const curve::Curve> curve;
  Vec3 p_WT;
  double largest_m = 0.0;  // of all coordinates
};

/// A curve of 2 to 12 points: any, collinear, turning back, or very near to each other. At most 1e3 m out.
Drawn drawCurve(Input& input, curve::CurveKind kind) {
  const double size_m = input.number("size_m", [](Dice& dice) { return dice.power(-20, 9); });
  const std::size_t count = 2 + input.choice("points", 11);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(input.vector("p", [&](Dice& dice) -> Vec3 {
      if (i > 1 && dice.one(6)) return points[i - 2] + size_m * dice.closeness() * dice.direction();
      if (i > 1 && dice.one(4)) return points[i - 1] + dice.share() * (points[i - 1] - points[i - 2]);
      if (i > 0 && dice.one(4)) return points[i - 1] + size_m * dice.power(-18, 0) * dice.direction();
      return dice.inBox(size_m);
    }));
  }
  const bool closed = input.flag("closed");
  const auto made = curve::makeCurve(points, kind, closed);
  Drawn drawn;
  drawn.p_WT = input.vector("p_WT", [&](Dice& dice) {
    const Vec3& near = points[dice.below(points.size())];
    if (dice.one(4)) return dice.oddPointAbout(near, Vec3::UnitZ(), size_m);
    return Vec3(near + size_m * (dice.one(2) ? dice.closeness() : 2.0) * dice.inBox(1.0));
  });
  if (made) {
    drawn.curve = made.value();
    drawn.largest_m = std::max(drawn.curve->largest_m, largestOf(drawn.p_WT));
  }
  return drawn;
}

/// The distance of p from a straight piece.
Real toStraight(const curve::Curve& curve, std::int32_t piece, const Real3& p) {
  const auto at = static_cast<std::size_t>(piece);
  return oracle::onSegment(real(curve.controls_W[at]), real(curve.controls_W[at + 1]), p).distance;
}

Outcome judgePolyline(Input& input) {
  const Drawn drawn = drawCurve(input, curve::CurveKind::Polyline);
  if (!drawn.curve) return {0.0, true};  // fewer than two different points
  if (drawn.p_WT.norm() > curve::kFarthestTip_m) return {0.0, true};
  curve::SearchState state;
  const curve::Nearest got =
      asTheServo([&] { return nearestPoint(*drawn.curve, curve::Search::Hybrid, drawn.p_WT, state); });
  if (!got.p_WP.allFinite() || !got.is_proved) return {kInfinity, false};
  const auto distanceOf = [&](const Real3& p) {
    Real best = toStraight(*drawn.curve, 0, p);
    for (std::int32_t piece = 1; piece < curve::pieceCount(*drawn.curve); ++piece)
      best = std::min(best, toStraight(*drawn.curve, piece, p));
    return best;
  };
  const Real3 tip = real(drawn.p_WT);
  const Real nearest = distanceOf(tip), farther = norm(real(got.p_WP) - tip) - nearest;
  return {
      std::max({ulpsOf(distanceOf(real(got.p_WP)), drawn.largest_m), ulpsOf(got.distance_m, nearest, drawn.largest_m),
                ulpsOf(farther > 0 ? farther : Real(0), drawn.largest_m)}),
      false};
}

/// A cubic by its powers of u.
struct Powers {
  std::array<Real3, 4> c;
  Real3 at(const Real& u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }
  Real3 slope(const Real& u) const { return c[1] + u * (Real(2) * c[2] + (3 * u) * c[3]); }
  Real3 bend(const Real& u) const { return Real(2) * c[2] + (6 * u) * c[3]; }
};
Powers powersOf(const Vec3* p) {
  const Real3 a = real(p[0]), b = real(p[1]), c = real(p[2]), d = real(p[3]);
  return {{a, Real(3) * (b - a), Real(3) * (a - Real(2) * b + c), d - a + Real(3) * (b - c)}};
}

/// The least distance of a piece, by Newton from the lowest of a row of starts: never too small.
Real toCubic(const Powers& cubic, const Real3& q) {
  constexpr int kStarts = 24;
  std::array<Real, kStarts + 1> squared;
  for (int i = 0; i <= kStarts; ++i) {
    const Real3 off = cubic.at(Real(i) / kStarts) - q;
    squared[static_cast<std::size_t>(i)] = dot(off, off);
  }
  Real best = *std::min_element(squared.begin(), squared.end());
  for (int i = 0; i <= kStarts; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool is_low = (i == 0 || squared[at] <= squared[at - 1]) && (i == kStarts || squared[at] <= squared[at + 1]);
    if (!is_low) continue;
    Real u = Real(i) / kStarts;
    for (int step = 0; step < 30; ++step) {
      const Real3 off = cubic.at(u) - q, slope = cubic.slope(u);
      const Real value = dot(off, slope), bend = dot(slope, slope) + dot(off, cubic.bend(u));
      if (bend <= 0) break;
      const Real next = clamped(Real(u - value / bend), 0, 1);
      if (next == u) break;
      u = next;
      const Real3 there = cubic.at(u) - q;
      best = std::min(best, dot(there, there));
    }
  }
  return sqrt(best);
}

Outcome judgeSpline(Input& input) {
  const Drawn drawn = drawCurve(input, curve::CurveKind::Spline);
  if (!drawn.curve) return {0.0, true};
  if (drawn.p_WT.norm() > curve::kFarthestTip_m) return {0.0, true};
  curve::SearchState state;
  const curve::Nearest got =
      asTheServo([&] { return nearestPoint(*drawn.curve, curve::Search::Hybrid, drawn.p_WT, state); });
  if (!got.p_WP.allFinite() || got.piece < 0) return {kInfinity, false};
  const Real3 tip = real(drawn.p_WT), found = real(got.p_WP);
  const auto pieceOf = [&](std::int32_t piece) {
    return powersOf(&drawn.curve->controls_W[3 * static_cast<std::size_t>(piece)]);
  };
  // 1e-13 of the distance, and 2^-43 of the largest coordinate, which is 512 ulp.
  const Real distance = norm(found - tip), scale = drawn.largest_m + Real(1e-13) * distance / ldexp(Real(1), -43);
  double worst = std::max(ulpsOf(norm(pieceOf(got.piece).at(got.u) - found), drawn.largest_m),
                          ulpsOf(got.distance_m, distance, drawn.largest_m));
  if (!got.is_proved) return {worst, true};
  for (std::int32_t piece = 0; piece < curve::pieceCount(*drawn.curve); ++piece) {
    const Real farther = distance - toCubic(pieceOf(piece), tip);
    if (farther > 0) worst = std::max(worst, ulpsOf(farther, scale));
  }
  return {worst, false};
}

/// A local search from a piece: its point is on the piece and at the distance that it states, no farther than the first
/// piece, nor than those beside the last one.
Outcome judgeLocal(Input& input, curve::CurveKind kind) {
  const Drawn drawn = drawCurve(input, kind);
  if (!drawn.curve || drawn.p_WT.norm() > curve::kFarthestTip_m) return {0.0, true};
  const curve::Curve& curve = *drawn.curve;
  const std::int32_t pieces = curve::pieceCount(curve);
  const auto from = static_cast<std::int32_t>(input.choice("from", static_cast<std::size_t>(pieces)));
  curve::SearchState state{from};
  const curve::Nearest got = asTheServo([&] { return nearestPoint(curve, curve::Search::Local, drawn.p_WT, state); });
  if (!got.p_WP.allFinite() || got.piece < 0 || got.piece >= pieces) return {kInfinity, false};
  const Real3 tip = real(drawn.p_WT), found = real(got.p_WP);
  const auto pieceAt = [&](std::int32_t piece) {
    return powersOf(&curve.controls_W[3 * static_cast<std::size_t>(piece)]);
  };
  const bool is_straight = kind == curve::CurveKind::Polyline;
  const auto toPiece = [&](std::int32_t piece) {
    return is_straight ? toStraight(curve, piece, tip) : toCubic(pieceAt(piece), tip);
  };
  const Real off = is_straight ? toStraight(curve, got.piece, found) : norm(pieceAt(got.piece).at(got.u) - found);
  const Real distance = norm(found - tip);
  const Real scale = drawn.largest_m + (is_straight ? Real(0) : Real(Real(1e-13) * distance / ldexp(Real(1), -43)));
  double worst = std::max(ulpsOf(off, drawn.largest_m), ulpsOf(got.distance_m, distance, drawn.largest_m));
  const auto compareWith = [&](std::int32_t piece) {
    const Real farther = distance - toPiece(piece);
    if (farther > 0) worst = std::max(worst, ulpsOf(farther, scale));
  };
  compareWith(from);
  for (const std::int32_t by : {-1, 0, 1}) {
    const std::int32_t beside = got.piece + by;
    if (beside >= 0 && beside < pieces) {
      compareWith(beside);
    } else if (curve.is_closed) {
      compareWith(beside < 0 ? pieces - 1 : 0);
    }
  }
  return {worst, false};
}

Outcome judgeLocalPolyline(Input& input) {
  return judgeLocal(input, curve::CurveKind::Polyline);
}
Outcome judgeLocalSpline(Input& input) {
  return judgeLocal(input, curve::CurveKind::Spline);
}

constexpr std::array<Row, 4> kRows{{
    {"curve_polyline", Kind::Shape, "Path of straight lines: nearest point",
     "ulp of the largest coordinate: off the path, farther than the nearest, distance", 8, 2, judgePolyline},
    {"curve_spline", Kind::Shape, "Path of cubics: nearest point",
     "ulp of the largest coordinate, and 1e-13 of the distance (farther than the nearest)", 512, 30, judgeSpline},
    {"curve_local", Kind::Shape, "Path of straight lines, searched along it from any piece",
     "ulp of the largest coordinate: off the piece, distance, farther than the first piece and those beside the last",
     8, 2, judgeLocalPolyline},
    {"curve_local_spline", Kind::Shape, "Path of cubics, searched along it from any piece",
     "ulp of the largest coordinate, and 1e-13 of the distance (farther than those pieces)", 512, 15, judgeLocalSpline},
}};

}  // namespace curves_rows

constinit const std::span<const Row> kCurveRows = curves_rows::kRows;

}  // namespace underact::error_bounds
