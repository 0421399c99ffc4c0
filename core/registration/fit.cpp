#include "core/registration/fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>
#include <string>

namespace underact::registration {
namespace {

constexpr double kSame_m = 1e-3;  // nearer than any hand can tell two marks apart
constexpr double kOnLine_m =
    2e-3;  // an error of 1 mm would turn the arm about the line by more than half a right angle
constexpr double kFarthest_m = 1e3;  // beyond it a millimetre is lost in rounding, and no desk is so large

Eigen::Matrix3Xd columnsOf(const std::vector<Vec3>& points) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t at = 0; at < points.size(); ++at) columns.col(static_cast<Eigen::Index>(at)) = points[at];
  return columns;
}

/// what: "marks", "touched points".
void judge(const std::vector<Vec3>& points, const std::string& what, Problems& problems) {
  for (const Vec3& point : points) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > kFarthest_m) {
      problems.push_back({"Not all of the " + what + " are finite points within 1 km.", {}});
      return;
    }
  }
  const Layout layout = layoutOf(points);
  if (layout.least_apart_m < kSame_m) {
    problems.push_back({"The " + what + " " + std::to_string(layout.near_one + 1) + " and " +
                            std::to_string(layout.near_other + 1) +
                            " are one and the same place. Touch them again, or "
                            "choose marks that are apart.",
                        {}});
  } else if (layout.off_line_m < kOnLine_m) {
    problems.push_back({"The " + what +
                            " lie on one line, so nothing says how the arm is turned about it. Choose a mark beside "
                            "the line.",
                        {}});
  }
}

}  // namespace

std::vector<Vec3> marksOf(const std::vector<Touch>& touches) {
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
  layout.least_apart_m = kInfinity;
  for (std::size_t one = 0; one < points.size(); ++one) {
    for (std::size_t other = one + 1; other < points.size(); ++other) {
      const double apart_m = (points[one] - points[other]).norm();
      if (apart_m < layout.least_apart_m) layout = {layout.off_line_m, apart_m, one, other};
    }
  }
  Eigen::Matrix3Xd away = columnsOf(points);
  away.colwise() -= away.rowwise().mean().eval();
  const Vec3 along = Eigen::JacobiSVD<Eigen::MatrixXd>(away, Eigen::ComputeThinU).singularValues();
  layout.off_line_m = std::hypot(along[1], along[2]) / std::sqrt(static_cast<double>(points.size()));
  return layout;
}

Result<Fit> fitTouches(const std::vector<Touch>& touches) {
  if (touches.size() < kFewestMarks || touches.size() > kMostMarks) {
    return Problems{{"A registration takes 3 to 8 marks; here there are " + std::to_string(touches.size()) + ".", {}}};
  }
  Problems problems;
  judge(marksOf(touches), "marks", problems);
  judge(touchedOf(touches), "touched points", problems);
  if (!problems.empty()) return problems;
  Fit fit;
  fit.X_DW.matrix() = Eigen::umeyama(columnsOf(touchedOf(touches)), columnsOf(marksOf(touches)), false);
  double sum_m2 = 0.0;
  for (const Touch& touch : touches) {
    fit.off_D.push_back(fit.X_DW * touch.p_WM - touch.p_DM);
    sum_m2 += fit.off_D.back().squaredNorm();
  }
  fit.rms_m = std::sqrt(sum_m2 / static_cast<double>(touches.size()));
  return fit;
}

}  // namespace underact::registration
