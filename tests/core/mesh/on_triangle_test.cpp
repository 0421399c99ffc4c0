#include "core/mesh/on_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/property.h"

namespace underact::mesh {
namespace {

TEST(OnTriangle, OfANeedleNoPointLiesBeyondItsShortEdge) {  // it did, by as much as the tip, up to 1e-12
  constexpr double kUlp = 0x1p-52;
  test::Random random(test::Seed{20070630});
  for (int i = 0; i < test::sweep(20'000, 1'000'000); ++i) {
    const Eigen::Vector3f a = random.inBox(1.0).cast<float>();
    const Eigen::Vector3f b = (a.cast<double>() + random.direction()).cast<float>();
    const Eigen::Vector3f c = (b.cast<double>() + std::ldexp(1.0, -21) * random.inBox(1.0)).cast<float>();
    const Vec3 along = (b - a).cast<double>().normalized(), from_b = b.cast<double>();
    const double beyond = std::ldexp(random.between(1.0, 2.0), -static_cast<int>(30 + random.below(20)));
    const Vec3 q = from_b + beyond * along + random.between(0.0, 1.0) * (c - b).cast<double>();
    const OnTriangle found = onTriangle(a, b, c, q);
    const double end = std::max(0.0, (c.cast<double>() - from_b).dot(along));
    // 4.5 ulp of the largest coordinate, 2 at most, are promised; the direction's rounding is that of 1e-6 beside it.
    ASSERT_LE((found.p_M - from_b).dot(along), end + 4.5 * 2.0 * kUlp) << i;
  }
}

}  // namespace
}  // namespace underact::mesh
