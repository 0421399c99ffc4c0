#include "core/registration/fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/decompositions.h"
#include "core/base/translate.h"

namespace underact::registration {
namespace {

constexpr double kSame_m = 1e-3;     // nearer than a hand can distinguish two points
constexpr double kOnLine_m = 2e-3;   // an error of 1 mm would rotate the arm about the line by more than 45 degrees
constexpr double kFarthest_m = 1e3;  // beyond it a millimetre is lost in rounding, and no desk is so large

Eigen::Matrix3Xd columnsOf(const std::vector<Vec3>& points) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t at = 0; at < points.size(); ++at) columns.col(static_cast<Eigen::Index>(at)) = points[at];
  return columns;
}

/// The sentences for points that cannot be used.
struct Words {
  const char* not_finite;
  const char* same;
  const char* on_line;
};
constexpr Words kOfMarks{TRANSLATE_NOOP("problem", "Not all of the reference points are finite points within 1 km."),
                         TRANSLATE_NOOP("problem",
                                        "The reference points %1 and %2 are at the same position. Touch them again, or "
                                        "choose reference points that are apart."),
                         TRANSLATE_NOOP("problem",
                                        "The reference points lie on one line, so how the arm is turned about it is "
                                        "unknown. Choose a reference point beside the line.")};
constexpr Words kTouchedPoints{
    TRANSLATE_NOOP("problem", "Not all of the touched points are finite points within 1 km."),
    TRANSLATE_NOOP("problem",
                   "The touched points %1 and %2 are at the same position. Touch them again, or choose reference "
                   "points that are apart."),
    TRANSLATE_NOOP("problem",
                   "The touched points lie on one line, so how the arm is turned about it is unknown. Choose a "
                   "reference point beside the line.")};

void judge(const std::vector<Vec3>& points, const Words& words, Problems& problems) {
  for (const Vec3& point : points) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > kFarthest_m) {
      problems.push_back({phrase(words.not_finite), {}});
      return;
    }
  }
  const Layout layout = layoutOf(points);
  if (layout.min_apart_m < kSame_m) {
    problems.push_back(
        {phrase(words.same, {std::to_string(layout.near_one + 1), std::to_string(layout.near_other + 1)}), {}});
  } else if (layout.off_line_m < kOnLine_m) {
    problems.push_back({phrase(words.on_line), {}});
  }
}

}  // namespace

std::vector<Vec3> referencePointsOf(const std::vector<Touch>& touches) {
  std::vector<Vec3> points;
  for (const Touch& touch : touches) points.push_back(touch.p_DM);
  return points;
}

std::vector<Vec3> touchedOf(const std::vector<Touch>& touches) {
  std::vector<Vec3> points;
  for (const Touch& touch : touches) points.push_back(touch.p_WM);
  return points;
}

Layout layoutOf(const std::vector<Vec3>& points) {
  Layout layout;
  layout.min_apart_m = kInfinity;
  for (std::size_t one = 0; one < points.size(); ++one) {
    for (std::size_t other = one + 1; other < points.size(); ++other) {
      const double apart_m = (points[one] - points[other]).norm();
      if (apart_m < layout.min_apart_m) layout = {layout.off_line_m, apart_m, one, other};
    }
  }
  Eigen::Matrix3Xd away = columnsOf(points);
  away.colwise() -= away.rowwise().mean().eval();
  // Of the scatter matrix: with an error of 1e-8 of the longest distance, far below what a hand can point at.
  const Vec3 squares_m2 = principalAxes(away * away.transpose()).values;
  layout.off_line_m = std::sqrt(std::max(0.0, squares_m2[0] + squares_m2[1]) / static_cast<double>(points.size()));
  return layout;
}

Result<Fit> fitTouches(const std::vector<Touch>& touches) {
  if (touches.size() < kFewestMarks || touches.size() > kMaxMarks) {
    return Problems{{phrase(TRANSLATE_NOOP("problem", "A registration needs 3 to 8 reference points; this one has %1."),
                            {std::to_string(touches.size())}),
                     {}}};
  }
  Problems problems;
  judge(referencePointsOf(touches), kOfMarks, problems);
  judge(touchedOf(touches), kTouchedPoints, problems);
  if (!problems.empty()) return problems;
  Fit fit;
  fit.X_DW.matrix() = Eigen::umeyama(columnsOf(touchedOf(touches)), columnsOf(referencePointsOf(touches)), false);
  double sum_m2 = 0.0;
  for (const Touch& touch : touches) {
    fit.off_D.push_back(fit.X_DW * touch.p_WM - touch.p_DM);
    sum_m2 += fit.off_D.back().squaredNorm();
  }
  fit.rms_m = std::sqrt(sum_m2 / static_cast<double>(touches.size()));
  return fit;
}

}  // namespace underact::registration
