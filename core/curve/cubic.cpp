#include "core/curve/cubic.h"

#include <cmath>

namespace underact::curve {
namespace {

struct Sample {
  double at;  // in [0, 1]
  double weight;
};
/// Source: Abramowitz and Stegun 1964, table 25.4, n = 8, brought from [-1, 1] to [0, 1].
constexpr std::array<Sample, 8> kGaussLegendre{{{0.019855071751231884158, 0.050614268145188129576},
                                                {0.1016667612931866302, 0.11119051722668723527},
                                                {0.23723379504183550709, 0.15685332293894364367},
                                                {0.40828267875217509753, 0.18134189168918099148},
                                                {0.59171732124782490247, 0.18134189168918099148},
                                                {0.76276620495816449291, 0.15685332293894364367},
                                                {0.8983332387068133698, 0.11119051722668723527},
                                                {0.98014492824876811584, 0.050614268145188129576}}};

Vec3 between(const Vec3& a, const Vec3& b, double u) noexcept UNDERACT_REAL_TIME {
  return (1.0 - u) * a + u * b;  // exact at both ends
}

}  // namespace

Vec3 pointOf(const Cubic& cubic, double u) noexcept {
  const Vec3 ab = between(cubic[0], cubic[1], u), bc = between(cubic[1], cubic[2], u);
  const Vec3 cd = between(cubic[2], cubic[3], u);
  return between(between(ab, bc, u), between(bc, cd, u), u);
}

Vec3 velocityOf(const Cubic& cubic, double u) noexcept {
  const Vec3 ab = cubic[1] - cubic[0], bc = cubic[2] - cubic[1], cd = cubic[3] - cubic[2];
  return 3.0 * between(between(ab, bc, u), between(bc, cd, u), u);
}

Halves halvesOf(const Cubic& cubic) noexcept {
  const Vec3 ab = 0.5 * (cubic[0] + cubic[1]), bc = 0.5 * (cubic[1] + cubic[2]), cd = 0.5 * (cubic[2] + cubic[3]);
  const Vec3 abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
  return {{cubic[0], ab, abc, middle}, {middle, bcd, cd, cubic[3]}};
}

double lengthUpTo(const Cubic& cubic, double u) noexcept {
  double length = 0.0;
  for (const Sample& sample : kGaussLegendre) length += sample.weight * velocityOf(cubic, u * sample.at).norm();
  return u * length;
}

}  // namespace underact::curve
