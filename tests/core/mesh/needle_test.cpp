#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/norms.h"
#include "core/mesh/on_triangle.h"
#include "tests/support/property.h"

namespace underact::mesh {
namespace {

// The oracle: 113 bits, where a needle's area keeps more digits than a double has; the nearest of all points that could
// be.
using Quad = boost::multiprecision::cpp_bin_float_quad;
using QuadPoint = std::array<Quad, 3>;

QuadPoint wide(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

QuadPoint along(const QuadPoint& from, const Quad& times, const QuadPoint& offset) {
  return {from[0] + times * offset[0], from[1] + times * offset[1], from[2] + times * offset[2]};
}

QuadPoint offset(const QuadPoint& from, const QuadPoint& to) {
  return along(to, -1, from);
}

Quad inner(const QuadPoint& u, const QuadPoint& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

Quad distance(const QuadPoint& p, const QuadPoint& q) {
  return sqrt(inner(offset(p, q), offset(p, q)));
}

Quad distanceToEdge(const QuadPoint& a, const QuadPoint& b, const QuadPoint& q) {
  const QuadPoint ab = offset(a, b);
  const Quad length2 = inner(ab, ab), t = length2 > 0 ? Quad(inner(offset(a, q), ab) / length2) : Quad(0);
  return distance(along(a, t < 0 ? Quad(0) : t > 1 ? Quad(1) : t, ab), q);
}

/// Distance of q from the triangle: from its edges, and from its foot a + u ab + v ac where that is inside.
Quad distanceToTriangle(const std::array<Vec3, 3>& corners, const Vec3& from) {
  const QuadPoint a = wide(corners[0]), b = wide(corners[1]), c = wide(corners[2]), q = wide(from);
  Quad best = std::min({distanceToEdge(a, b, q), distanceToEdge(b, c, q), distanceToEdge(c, a, q)});
  const QuadPoint ab = offset(a, b), ac = offset(a, c), aq = offset(a, q);
  const Quad bb = inner(ab, ab), bc = inner(ab, ac), cc = inner(ac, ac), whole = bb * cc - bc * bc;
  if (!(whole > 0)) return best;
  const Quad u = (cc * inner(aq, ab) - bc * inner(aq, ac)) / whole;
  const Quad v = (bb * inner(aq, ac) - bc * inner(aq, ab)) / whole;
  if (u < 0 || v < 0 || u + v > 1) return best;
  return std::min(best, distance(along(along(a, u, ab), v, ac), q));
}

/// Edges of 1, 1 and 2^-21 in any order, and a place a little beyond one of its ends, beside it, or above any of that.
struct Needle {
  std::array<Vec3, 3> corners;
  Vec3 q;
};

Needle drawNeedle(test::Random& random) {
  const auto asFloats = [](const Vec3& v) { return Vec3(v.cast<float>().cast<double>()); };
  const Vec3 tip = asFloats(random.inBox(1.0)), end = asFloats(tip + random.direction());
  const Vec3 other = asFloats(end + 0x1p-21 * random.inBox(1.0));
  const double beyond = std::ldexp(random.between(1.0, 2.0), -static_cast<int>(30 + random.below(20)));
  const Vec3 axis = (end - tip).normalized();
  Vec3 q = random.below(2) == 0 ? Vec3(tip - beyond * axis)
                                : Vec3(end + beyond * axis + random.between(0.0, 1.0) * (other - end));
  const Vec3 across = (end - tip).cross(other - tip);
  if (random.below(3) > 0 && across.norm() > 0.0) q += random.between(-1.0, 1.0) * across.normalized();
  std::array<Vec3, 3> corners{tip, end, other};
  std::swap(corners[random.below(3)], corners[2]);
  std::swap(corners[random.below(2)], corners[1]);
  return {corners, q};
}

TEST(Needle, FromAboveToNoPointIsFoundBeyondItsEndsNorFartherThanTheNearest) {  // it was, by up to 6e-10
  test::Random random(test::Seed{20070701});
  double off_ulp = 0.0, farther_ulp = 0.0;
  for (int i = 0; i < test::sweep(20'000, 1'000'000); ++i) {
    const auto [corners, q] = drawNeedle(random);
    const auto& [a, b, c] = corners;
    const OnTriangle found = onTriangle(a.cast<float>(), b.cast<float>(), c.cast<float>(), q);
    const double ulp = 0x1p-52 * std::max({largestOf(a), largestOf(b), largestOf(c), largestOf(q)});
    const Quad far = distance(wide(found.p_M), wide(q)) - distanceToTriangle(corners, q);
    off_ulp = std::max(off_ulp, static_cast<double>(distanceToTriangle(corners, found.p_M)) / ulp);
    farther_ulp = std::max(farther_ulp, static_cast<double>(far) / ulp);
    ASSERT_LE(off_ulp, 4.5) << i;
    ASSERT_LE(farther_ulp, 4.5) << i;
  }
  RecordProperty("off_ulp", std::to_string(off_ulp));
  RecordProperty("farther_ulp", std::to_string(farther_ulp));
}

[[gnu::noinline]] void toFloatsAndBack(const double* exact, double* rounded) {
  const float x = static_cast<float>(exact[0]), y = static_cast<float>(exact[1]);
  rounded[0] = static_cast<double>(x);
  rounded[1] = static_cast<double>(y);
}

// Why OfANeedleNoPointLiesBeyondItsShortEdge failed in 5 of 20 000 draws: its own corners were not floats. Where GCC 12
// vectorizes straight-line code, it drops the two conversions, unless it is told not to (cmake/underact_room.cmake).
TEST(Needle, WhatIsRoundedToAFloatIsRoundedWhateverIsOptimized) {
  test::Random random(test::Seed{20070702});
  for (int i = 0; i < 1000; ++i) {
    const std::array<double, 2> exact{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
    std::array<double, 2> rounded{};
    toFloatsAndBack(exact.data(), rounded.data());
    volatile float x = static_cast<float>(exact[0]), y = static_cast<float>(exact[1]);
    ASSERT_EQ(rounded[0], static_cast<double>(x));
    ASSERT_EQ(rounded[1], static_cast<double>(y));
  }
}

}  // namespace
}  // namespace underact::mesh
