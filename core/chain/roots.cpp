#include "core/chain/roots.h"

#include <algorithm>
#include <cmath>

namespace underact::chain {
namespace {

constexpr double kTouches = 1e-13;      // of the largest term: some hundred roundings
constexpr double kCancelled = 0x1p-48;  // of the largest coefficient: a smaller one may be the rounding of its parts
constexpr int kMaxHalvings =
    200;  // from the largest double to one ulp of 1 would take 1100; roots lie in a few thousand

double valueAt(const Quartic& c, std::size_t degree, double t) noexcept {
  double value = c[degree];
  for (std::size_t i = degree; i-- > 0;) value = value * t + c[i];
  return value;
}

/// The largest size that a term takes at t: what rounding is measured by.
double largestTerm(const Quartic& c, std::size_t degree, double t) noexcept {
  double largest = 0.0, power = 1.0;
  for (std::size_t i = 0; i <= degree; ++i, power *= t) largest = std::max(largest, std::abs(c[i] * power));
  return largest;
}

Quartic derivativeOf(const Quartic& c, std::size_t degree) noexcept {
  Quartic d{};
  for (std::size_t i = 1; i <= degree; ++i) d[i - 1] = static_cast<double>(i) * c[i];
  return d;
}

/// The root between a and b, where the signs differ; Newton's step where it stays inside, else half way.
double between(const Quartic& c, const Quartic& d, std::size_t degree, double a, double b) noexcept {
  const bool rises = valueAt(c, degree, b) > 0.0;
  double t = 0.5 * (a + b);
  for (int i = 0; i < kMaxHalvings; ++i) {
    const double value = valueAt(c, degree, t);
    if (value == 0.0) return t;
    ((value > 0.0) == rises ? b : a) = t;
    const double slope = valueAt(d, degree - 1, t), newton = t - value / slope;
    const double next = newton > a && newton < b ? newton : 0.5 * (a + b);
    if (next == t || !(a < next && next < b)) return t;
    t = next;
  }
  return t;
}

void addRoot(Roots& roots, double t) noexcept {
  if (roots.count < roots.all.size() && (roots.count == 0 || roots.all[roots.count - 1] != t))
    roots.all[roots.count++] = t;
}

/// Of a polynomial between the zeros of its derivative, d: it is monotonous on each stretch.
Roots betweenTurns(const Quartic& c, const Quartic& d, std::size_t degree, const Roots& turns, double low,
                   double high) noexcept {
  Roots roots;
  const auto sideOf = [&](double t) {  // -1, 0 or 1
    const double value = valueAt(c, degree, t);
    if (std::abs(value) <= std::max(kTouches * largestTerm(c, degree, t), kCancelled * largestTerm(c, degree, 1.0)))
      return 0;
    return value > 0.0 ? 1 : -1;
  };
  double a = low;
  int side_a = sideOf(a);
  if (side_a == 0) addRoot(roots, a);
  for (std::size_t i = 0; i <= turns.count; ++i) {
    const double b = i < turns.count ? turns.all[i] : high;
    const int side_b = sideOf(b);
    if (side_a * side_b < 0) addRoot(roots, between(c, d, degree, a, b));
    if (side_b == 0) addRoot(roots, b);
    a = b, side_a = side_b;
  }
  return roots;
}

/// Of the degree exactly: from its last derivative, a constant, up to itself.
Roots isolated(const Quartic& c, std::size_t degree, double low, double high) noexcept {
  std::array<Quartic, 5> derivatives{c};  // of each order
  for (std::size_t order = 1; order <= degree; ++order)
    derivatives[order] = derivativeOf(derivatives[order - 1], degree - order + 1);
  Roots roots;
  for (std::size_t order = degree; order-- > 0;)
    roots = betweenTurns(derivatives[order], derivatives[order + 1], degree - order, roots, low, high);
  return roots;
}

}  // namespace

Quartic product(const Quadratic& a, const Quadratic& b, double factor) noexcept {
  Quartic c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) c[i + j] += factor * a[i] * b[j];
  }
  return c;
}

Quartic sum(const Quartic& a, const Quartic& b) noexcept {
  Quartic c = a;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] += b[i];
  return c;
}

Roots rootsWithin(const Quartic& c, double low, double high) noexcept {
  double largest = 0.0;
  bool finite = true;
  for (const double one : c) {
    finite &= std::isfinite(one);
    largest = std::max(largest, std::abs(one));
  }
  if (!finite || !(largest > 0.0)) return {};
  Quartic scaled{};
  std::size_t degree = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    scaled[i] = c[i] / largest;
    if (scaled[i] != 0.0) degree = i;
  }
  return isolated(scaled, degree, low, high);
}

Roots rootsOf(const Quartic& c) noexcept {
  const Roots inside = rootsWithin(c, -1.0, 1.0);  // and those beyond as 1 / t of the polynomial read backwards
  const Roots outside = rootsWithin({c[4], c[3], c[2], c[1], c[0]}, -1.0, 1.0);
  Roots roots;
  for (std::size_t i = 0; i < outside.count; ++i) {
    const double t = outside.all[i];
    if (std::abs(t) < 1.0 && std::abs(t) > 1e-12) addRoot(roots, 1.0 / t);
  }
  for (std::size_t i = 0; i < inside.count; ++i) addRoot(roots, inside.all[i]);
  std::sort(roots.all.begin(), roots.all.begin() + static_cast<std::ptrdiff_t>(roots.count));
  return roots;
}

}  // namespace underact::chain
