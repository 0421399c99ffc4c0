#include "core/base/nearest_rotation.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/base/translate.h"

namespace underact {
namespace {

constexpr double kSixDecimals = 2e-6;  // of R R^T: 2 sqrt(3) times half of the sixth decimal
constexpr double kRegular = 0.1;       // of the determinant; less is no rotation, however it was rounded

double offOrthonormal(const Mat3& R) {
  return (R * R.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff();
}

bool hasNearest(const Mat3& R) {
  return R.allFinite() && R.cwiseAbs().maxCoeff() <= 2.0 && R.determinant() > kRegular;
}

std::string twoDigits(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 2).ptr;
  return {text.data(), end};
}

}  // namespace

Mat3 nearestRotation(const Mat3& R) {
  constexpr int kSteps = 20;  // quadratic: six from within 1e-3
  constexpr double kConverged = 1e-15;
  if (!hasNearest(R)) return R;
  Mat3 polar = R;
  const bool is_rounded = offOrthonormal(R) > kSixDecimals;
  for (int step = 0; is_rounded && step < kSteps && offOrthonormal(polar) > kConverged; ++step)
    polar = Mat3(0.5 * (polar + polar.inverse().transpose()));
  return Eigen::Quaterniond(polar).normalized().toRotationMatrix();
}

Mat3 meantRotation(const Mat3& R) {
  return offOrthonormal(R) <= kSixDecimals ? R : nearestRotation(R);
}

double offRotation(const Mat3& R) {
  return hasNearest(R) ? (R - nearestRotation(R)).cwiseAbs().maxCoeff() : kInfinity;
}

Sentence rotationProblem(const Mat3& R) {
  const double off = offRotation(R);
  if (off <= kFarthestRotation) return {};
  if (!std::isfinite(off))
    return phrase(TRANSLATE_NOOP("problem",
                                 "This is not a rotation matrix: its rows must have length 1, be at right angles, and "
                                 "form a right-handed frame."));
  return phrase(TRANSLATE_NOOP("problem",
                               "This is not a rotation matrix: a number in it is %1 off the nearest one, and 0.001 is "
                               "allowed. Give at least four decimals, better six."),
                {twoDigits(off)});
}

Sentence rotationNote(const Mat3& R) {
  if (offOrthonormal(R) <= kSixDecimals) return {};
  return phrase(
      TRANSLATE_NOOP("problem",
                     "This matrix is %1 off a rotation, and the nearest one is taken. With six decimals it is "
                     "exact enough."),
      {twoDigits(offRotation(R))});
}

}  // namespace underact
