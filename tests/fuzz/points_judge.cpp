#include "tests/fuzz/points_judge.h"

#include <algorithm>
#include <cmath>

#include "core/curve/guidance.h"
#include "core/curve/points.h"

namespace underact::test {
namespace {

std::string judgeRefusal(const Problems& problems, std::string_view text) {
  if (problems.empty() || problems.size() > curve::kMaxProblems) return "Refused with no problem, or too many.";
  const auto isEnd = [](char c) { return c == '\n' || c == '\r'; };
  const auto lines = static_cast<int>(std::count_if(text.begin(), text.end(), isEnd)) + 1;
  int last = 0;
  for (const Problem& problem : problems) {
    const std::string given = describe(problem);
    const bool is_of_all =
        problem.place.line == 0 && problems.size() == 1 && problem.sentence == "The file has no points.";
    if (problem.place.line > lines || (problem.place.line <= last && !is_of_all))
      return "No line of the file: " + given;
    if (problem.sentence.size() < 10 || problem.sentence.back() != '.') return "No sentence: " + given;
    if (problem.sentence.pattern().empty()) return "No other language can say: " + given;
    if (given.size() > 1000 || given.find('\n') != std::string::npos) return "Not one line: " + given;
    last = problem.place.line;
  }
  return {};
}

std::string judgeCurve(const std::vector<Vec3>& points_W, curve::CurveKind kind, bool closed) {
  const auto made = curve::makeCurve(points_W, kind, closed);
  if (!made) return made.problems().empty() ? "No curve without a problem." : "";
  const curve::Curve& path = *made.value();
  curve::SearchState search;
  curve::GuidanceState state;
  for (const Vec3& p_WT : {Vec3(0, 0, 0), Vec3(1e-3, -0.2, 0.1), points_W.back()}) {
    const curve::Nearest nearest = nearestPoint(path, curve::Search::Hybrid, p_WT, search);
    const curve::GuidedTarget guided = guidedTarget(path, {0.3, 0.1, 0.02}, nearest, p_WT, 1e-3, state);
    if (!nearest.p_WP.allFinite() || !std::isfinite(nearest.s_m) || !guided.p_WP.allFinite()) return "Not finite.";
    if (nearest.s_m < 0.0 || nearest.s_m > lengthOf(path)) return "Beyond the curve's ends.";
    for (const Vec3& p_W : {points_W.front(), points_W.back()}) {
      // Points left out as the same, and rounding, of coordinates up to 1e3 m.
      if ((p_W - p_WT).norm() < nearest.distance_m - 1e-9) return "A point of the file is nearer.";
    }
  }
  return {};
}

std::string judgeCurves(const std::vector<Vec3>& points) {
  std::vector<Vec3> points_W;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) return "A point is not finite.";
    if (i > 0 && points[i] == points[i - 1]) return "Two neighbours are equal.";
    points_W.push_back(1e-3 * points[i]);
  }
  for (const curve::CurveKind kind : {curve::CurveKind::Polyline, curve::CurveKind::Spline}) {
    for (const bool closed : {false, true}) {
      const std::string wrong = judgeCurve(points_W, kind, closed);
      if (!wrong.empty()) return wrong;
    }
  }
  return {};
}

}  // namespace

std::string judgePoints(std::string_view text) {
  const Result<std::vector<Vec3>> points = curve::parsePoints(text, "fuzz.txt");
  return points ? judgeCurves(points.value()) : judgeRefusal(points.problems(), text);
}

bool arePoints(std::string_view text) {
  return static_cast<bool>(curve::parsePoints(text, "fuzz.txt"));
}

}  // namespace underact::test
