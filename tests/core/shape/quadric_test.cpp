#include "core/shape/quadric.h"

#include <vector>

#include "tests/support/property.h"

namespace underact::shape {
namespace {

using Real = long double;  // 64 or more bits of fraction

/// The same point by bisection, in another unknown and another number (Eberly's own way): shares no line with Newton.
template <std::size_t N>
std::array<Real, N> byBisection(const std::array<double, N>& semi, const std::array<double, N>& y) {
  Real min = semi[0];
  for (const double one : semi) min = std::min<Real>(min, one);
  const auto excess = [&](Real u) {  // u = t + least^2 > 0
    Real sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const Real e = semi[i], gap = (e - min) * (e + min);
      if (y[i] != 0.0) sum += (e * y[i] / (u + gap)) * (e * y[i] / (u + gap));
    }
    return sum - 1;
  };
  Real low = 0, high = 0;
  for (std::size_t i = 0; i < N; ++i) high += semi[i] * std::abs(static_cast<Real>(y[i]));
  while (true) {
    // Halves the exponent's range first: a root may be 1e-200.
    const Real middle =
        low > 0 && high / low < 4 ? (low + high) / 2 : std::sqrt((low > 0 ? low : Real(1e-600L)) * high);
    if (!(middle > low && middle < high)) break;
    (excess(middle) > 0 ? low : high) = middle;
  }
  std::array<Real, N> x{};
  for (std::size_t i = 0; i < N; ++i) {
    const Real e = semi[i], gap = (e - min) * (e + min);
    x[i] = y[i] == 0.0 ? 0 : e * e * y[i] / (high + gap);
  }
  return x;
}

template <std::size_t N>
void expectNearest(const std::array<double, N>& semi, const std::array<double, N>& y) {
  const OnQuadric<N> found = nearestOnQuadric<N>(semi, y);
  ASSERT_EQ(found.status, Status::Unique);
  const std::array<Real, N> other = byBisection<N>(semi, y);
  Real on = 0, distance = 0, other_distance = 0, size = 0;
  for (std::size_t i = 0; i < N; ++i) {
    ASSERT_TRUE(std::isfinite(found.x[i]));
    ASSERT_TRUE(found.x[i] * y[i] >= 0.0);  // the nearest point is on the tip's own side
    on += (Real(found.x[i]) / semi[i]) * (Real(found.x[i]) / semi[i]);
    distance += (Real(found.x[i]) - y[i]) * (Real(found.x[i]) - y[i]);
    other_distance += (other[i] - y[i]) * (other[i] - y[i]);
    size = std::max({size, std::abs(Real(y[i])), Real(semi[i])});
  }
  const auto text = [&] {
    std::string all;
    for (std::size_t i = 0; i < N; ++i)
      all += std::to_string(i) + ": " + ::testing::PrintToString(semi[i]) + " at " + ::testing::PrintToString(y[i]) +
             " -> " + ::testing::PrintToString(found.x[i]) + " oracle " +
             ::testing::PrintToString(static_cast<double>(other[i])) + "\n";
    return all;
  };
  // On it: N shares, each of some 4 roundings, squared. This is what fails where Newton stops before it is there.
  ASSERT_NEAR(static_cast<double>(on), 1.0, 64 * 0x1p-52) << text();
  // As near as any: the distance is stationary, so it is good to the rounding of its terms even where x is badly
  // conditioned.
  ASSERT_LE(static_cast<double>(std::sqrt(distance)),
            static_cast<double>(std::sqrt(other_distance) + 64 * 0x1p-52L * size))
      << text();
}

TEST(Quadric, ByHandTheFarEndOfTheLongAxis) {
  const OnQuadric<2> on = nearestOnQuadric<2>({2.0, 1.0}, {5.0, 0.0});
  EXPECT_EQ(on.x[0], 2.0);
  EXPECT_EQ(on.x[1], 0.0);
  EXPECT_FALSE(on.inside);
  const OnQuadric<2> top = nearestOnQuadric<2>({2.0, 1.0}, {0.0, -0.25});
  EXPECT_EQ(top.x[0], 0.0);
  EXPECT_EQ(top.x[1], -1.0);
  EXPECT_TRUE(top.inside);
}

TEST(Quadric, SemiAxesUpToAMillionToOne) {
  test::Random random(test::Seed{20070631});
  for (int draw = 0; draw < test::sweep(20000, 1000000); ++draw) {
    const auto semi = [&] { return 0.05 * std::pow(10.0, random.between(-6.0, 0.0)); };
    const auto coordinate = [&] {
      return std::pow(10.0, random.between(-9.0, 1.0)) * (random.below(2) == 0 ? -1.0 : 1.0);
    };
    const std::array<double, 3> semi3{semi(), semi(), semi()}, y3{coordinate(), coordinate(), coordinate()};
    ASSERT_NO_FATAL_FAILURE(expectNearest<3>(semi3, y3)) << draw;
    ASSERT_NO_FATAL_FAILURE(expectNearest<2>({semi3[0], semi3[1]}, {y3[0], y3[1]})) << draw;
  }
}

TEST(Quadric, OnTheAxesAndInThePlanes) {
  const std::vector<double> places{0.0, 1e-300, 1e-12, 0.2, 0.999, 1.0, 1.5, 1e3};
  for (const double x : places) {
    for (const double y : places) {
      for (const double z : places) {
        const std::array<double, 3> at{x, -y, z};
        if (nearestOnQuadric<3>({3.0, 2.0, 1.0}, at).status == Status::NotUnique) {
          // Only in the middle of the thinnest axis, within the evolute.
          EXPECT_LE(z, 1e-12);
          EXPECT_LT((3 * x / 8) * (3 * x / 8) + (2 * y / 3) * (2 * y / 3), 1.0);
          continue;
        }
        ASSERT_NO_FATAL_FAILURE(expectNearest<3>({3.0, 2.0, 1.0}, at)) << x << " " << y << " " << z;
      }
    }
  }
}

TEST(Quadric, OnTheEvolute) {  // where three normals meet and Newton's slope vanishes
  for (double a = 0.0; a < 6.3; a += 0.01) {
    for (const double ratio : {1.0 + 0x1p-50, 1.0 + 1e-9, 1.5, 10.0, 1e3, 1e6}) {
      const double first = ratio, second = 1.0, difference = (first - second) * (first + second);
      const double c = std::cos(a), s = std::sin(a);
      const std::array<double, 2> y{difference / first * c * c * c, -difference / second * s * s * s};
      const OnQuadric<2> on = nearestOnQuadric<2>({first, second}, y);
      if (on.status == Status::Unique) {
        ASSERT_NO_FATAL_FAILURE(expectNearest<2>({first, second}, y)) << a << " " << ratio;
      }
    }
  }
}

TEST(Quadric, BesideTheMiddleOfTheThinnestAxis) {  // the multiplier is small, and Newton from afar is slow there
  for (const double along : {0.0, 0.5, 1.0 - 1e-3, 1.0 - 1e-9, 1.0 - 0x1p-53, 1.0, 1.0 + 0x1p-52, 1.0 + 1e-9, 1.1}) {
    for (const double share : {0.0, 0.3, 0.5, 1.0}) {
      for (const double off : {1e-320, 1e-300, 1e-200, 1e-100, 1e-30, 1e-17, 1e-15, 1e-12, 1e-9, 1e-3}) {
        // The cusp of the evolute is at (semi^2 - 1) / semi on each axis; in between on an ellipse.
        const std::array<double, 3> semi{3.0, 2.0, 1.0};
        const std::array<double, 3> y{along * std::sqrt(share) * 8.0 / 3.0, along * std::sqrt(1.0 - share) * 3.0 / 2.0,
                                      off};
        if (nearestOnQuadric<3>(semi, y).status == Status::Unique) {
          ASSERT_NO_FATAL_FAILURE(expectNearest<3>(semi, y)) << along << " " << share << " " << off;
        }
        const std::array<double, 2> flat{along * 8.0 / 3.0, off};
        if (nearestOnQuadric<2>({3.0, 1.0}, flat).status == Status::Unique) {
          ASSERT_NO_FATAL_FAILURE(expectNearest<2>({3.0, 1.0}, flat)) << along << " " << off;
        }
      }
    }
  }
}

TEST(Quadric,
     ATinyPoleBesideTwoLongAxesIsNoTrap) {  // each long axis alone is inside the evolute, both together are outside
  for (const double off : {1e-320, 1e-300, 1e-200, 1e-100, 1e-30, 1e-17, 1e-12}) {
    for (const double beyond : {1.0, 1.0 + 1e-15, 1.0 + 1e-12, 1.0 + 1e-6, 1.3}) {
      const double each = std::sqrt(beyond / 2.0);
      ASSERT_NO_FATAL_FAILURE(expectNearest<3>({3.0, 2.0, 1.0}, {each * 8.0 / 3.0 * (1 + 0x1p-51), each * 1.5, off}))
          << off << " " << beyond;
    }
  }
}

TEST(Quadric, ASphereIsASphere) {
  const OnQuadric<3> on = nearestOnQuadric<3>({0.5, 0.5, 0.5}, {0.3, 0.0, 0.4});
  EXPECT_NEAR(on.x[0], 0.3, 2e-16);
  EXPECT_NEAR(on.x[2], 0.4, 2e-16);
  EXPECT_EQ(nearestOnQuadric<3>({0.5, 0.5, 0.5}, {0, 0, 0}).status, Status::NotUnique);
  for (const double off : {1e-300, 1e-100, 1e-12}) {  // 8 epsilon of the size is where a direction ends
    EXPECT_EQ(nearestOnQuadric<3>({0.5, 0.5, 0.5}, {0, off, 0}).status,
              off < 1e-15 ? Status::NotUnique : Status::Unique);
  }
}

}  // namespace
}  // namespace underact::shape
