#include "core/chain/chain.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/translate.h"

namespace underact::chain {
namespace {

// The tolerance for a home pose read from text with 9 digits.
constexpr double kRotation = 1e-8;

/// Checks a joint, and normalises axis_W where it has a direction.
void check(Joint& joint, std::size_t number, const SourceLocation& place, Problems& problems) {
  const std::string which = std::to_string(number);
  const double length = joint.axis_W.stableNorm();
  if (length > 0.0 && std::isfinite(length)) {
    joint.axis_W /= length;
  } else {
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "Joint %1: the axis has no direction."), {which}), place});
  }
  if (!joint.p_WJ.allFinite())
    problems.push_back(
        {phrase(TRANSLATE_NOOP("problem", "Joint %1: the point on the axis is not a finite point."), {which}), place});
  if (!(joint.min <= joint.max) || joint.min == kInfinity || joint.max == -kInfinity) {
    problems.push_back(
        {phrase(TRANSLATE_NOOP("problem", "Joint %1: the lower limit must not be above the upper one."), {which}),
         place});
  }
}

bool isRotation(const Mat3& R) {
  return R.allFinite() && (R * R.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() <= kRotation &&
         R.determinant() > 0.0;
}

}  // namespace

Result<Chain> makeChain(std::vector<Joint> joints, const Pose& X_WT_home, const SourceLocation& place) {
  Problems problems;
  if (joints.empty())
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "A chain needs at least one joint.")), place});
  if (joints.size() > kMaxJoints) {
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "A chain has at most %1 joints, not %2."),
                               {std::to_string(kMaxJoints), std::to_string(joints.size())}),
                        place});
  }
  for (std::size_t i = 0; i < joints.size(); ++i) check(joints[i], i + 1, place, problems);
  if (!isRotation(X_WT_home.linear())) {
    problems.push_back(
        {phrase(TRANSLATE_NOOP("problem", "The upper left 3 x 3 numbers of the home pose are not a rotation matrix.")),
         place});
  }
  if (!X_WT_home.translation().allFinite())
    problems.push_back(
        {phrase(TRANSLATE_NOOP("problem", "The position of the home pose is not a finite point.")), place});
  if (!problems.empty()) return problems;
  return Chain{std::move(joints), X_WT_home};
}

Chain chainFromDh(std::span<const DhRow> rows, const Pose& X_WB, const Pose& X_NT) {
  rows = rows.first(std::min(rows.size(), kMaxJoints));
  const std::vector<double> home(rows.size(), 0.0);
  std::vector<Pose> X_WFrames(rows.size(), Pose::Identity());
  framesOf(rows, X_WB, home, X_WFrames);
  Chain chain;
  chain.joints.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vec3 axis_W = X_WFrames[i].linear().col(2).normalized();
    chain.joints.push_back({rows[i].type, axis_W, X_WFrames[i].translation(), rows[i].min, rows[i].max});
  }
  chain.X_WT_home = rows.empty() ? X_WB * X_NT : X_WFrames.back() * X_NT;
  return chain;
}

double reachOf(const Chain& chain) noexcept {
  double reach_m = 0.0;
  const Vec3* p_WLast = nullptr;
  for (const Joint& joint : chain.joints) {
    if (joint.type == JointType::Prismatic) {
      const double travel_m = std::max(std::abs(joint.min), std::abs(joint.max));
      if (travel_m < kInfinity) reach_m += travel_m;
    }
    if (p_WLast != nullptr) reach_m += (joint.p_WJ - *p_WLast).norm();
    p_WLast = &joint.p_WJ;
  }
  if (p_WLast != nullptr) reach_m += (chain.X_WT_home.translation() - *p_WLast).norm();
  return reach_m;
}

}  // namespace underact::chain
