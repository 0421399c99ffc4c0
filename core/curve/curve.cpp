#include "core/curve/curve.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/norms.h"
#include "core/base/translate.h"
#include "core/curve/along.h"
#include "core/curve/points.h"
#include "core/curve/spline.h"
#include "core/shape/nearest.h"

namespace underact::curve {
namespace {

Problems problemsOf(const std::vector<Vec3>& points_W, const SourceLocation& place) {
  Problems problems;
  if (points_W.size() > kMaxPoints)
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "A curve has at most 1000000 points.")), place});
  for (std::size_t i = 0; i < points_W.size() && problems.empty(); ++i) {
    const std::string number = std::to_string(i + 1);
    if (!points_W[i].allFinite()) {
      problems.push_back(
          {phrase(TRANSLATE_NOOP("problem", "Point %1 of the curve is not a finite point."), {number}), place});
    } else if (largestOf(points_W[i]) > kFarthest_m) {
      problems.push_back(
          {phrase(TRANSLATE_NOOP("problem",
                                 "Point %1 of the curve is farther than 1e6 mm from the origin; check the scale."),
                  {number}),
           place});
    }
  }
  return problems;
}

void leaveOutRepeated(std::vector<Vec3>& points_W, bool closed, double same_m) {
  const auto isSame = [&](const Vec3& a, const Vec3& b) { return (a - b).norm() <= same_m; };
  points_W.erase(std::unique(points_W.begin(), points_W.end(), isSame), points_W.end());
  while (closed && points_W.size() > 1 && isSame(points_W.front(), points_W.back())) points_W.pop_back();
}

/// The sums so far, with Kahan's correction: a million lengths keep their digits.
void addUp(Curve& curve) {
  const std::size_t pieces = (curve.controls_W.size() - 1) / static_cast<std::size_t>(controlsPerPiece(curve.kind));
  curve.s_m.assign(pieces + 1, 0.0);
  double missing_m = 0.0;
  for (std::size_t i = 0; i < pieces; ++i) {
    const double length_m = lengthUpTo(curve, static_cast<std::int32_t>(i), 1.0) - missing_m;
    const double sum_m = curve.s_m[i] + length_m;
    missing_m = (sum_m - curve.s_m[i]) - length_m;
    curve.s_m[i + 1] = std::max(curve.s_m[i], sum_m);
  }
}

}  // namespace

Result<std::shared_ptr<const Curve>> makeCurve(std::vector<Vec3> points_W, CurveKind kind, bool closed,
                                               const SourceLocation& place) {
  const Problems problems = problemsOf(points_W, place);
  if (!problems.empty()) return problems;
  auto curve = std::make_shared<Curve>();
  curve->kind = kind;
  curve->is_closed = closed;
  for (const Vec3& p_W : points_W) curve->largest_m = std::max(curve->largest_m, largestOf(p_W));
  leaveOutRepeated(points_W, closed, std::max(kSamePoint_m, shape::kDirectionLost * curve->largest_m));
  if (points_W.size() < (closed ? 3U : 2U)) {
    const char* sentence = closed ? TRANSLATE_NOOP("problem", "A closed curve needs at least 3 different points.")
                                  : TRANSLATE_NOOP("problem", "A curve needs at least 2 different points.");
    return Problems{{phrase(sentence), place}};
  }
  if (kind == CurveKind::Spline) {
    curve->controls_W = splineControls(points_W, closed);
  } else {
    curve->controls_W = std::move(points_W);
    if (closed) curve->controls_W.push_back(curve->controls_W.front());
  }
  addUp(*curve);
  curve->boxes = makeBoxes(curve->controls_W, controlsPerPiece(kind));
  return std::shared_ptr<const Curve>(std::move(curve));
}

std::size_t bytesOf(const Curve& curve) {
  return sizeof curve + curve.controls_W.capacity() * sizeof(Vec3) + curve.s_m.capacity() * sizeof(double) +
         curve.boxes.nodes.capacity() * sizeof(Node);
}

}  // namespace underact::curve
