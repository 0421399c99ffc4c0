#include "core/mesh/on_triangle.h"

#include <algorithm>

namespace underact::mesh {
namespace {

/// The squared sine between two edges below which a triangle counts as a sliver: the shares are off by some ulp over
/// that sine, so from here on by some ten of them.
constexpr double kThin = 1e-2;

/// A product and its rounding error, exactly. Source: Dekker 1971, A floating-point technique for extending the
/// available precision.
struct Product {
  double rounded, rest;
};
Product product(double x, double y) noexcept UNDERACT_REAL_TIME {
  constexpr double kSplit = 0x1p27 + 1.0;
  const double x_high = kSplit * x - (kSplit * x - x), x_low = x - x_high;
  const double y_high = kSplit * y - (kSplit * y - y), y_low = y - y_high;
  const double rounded = x * y;
  return {rounded, ((x_high * y_high - rounded) + x_high * y_low + x_low * y_high) + x_low * y_low};
}

/// u x v for nearly parallel vectors, within 2 ulp of itself, in spite of cancellation.
Vec3 exactCross(const Vec3& u, const Vec3& v) noexcept UNDERACT_REAL_TIME {
  const auto minor = [&](Eigen::Index i, Eigen::Index j) noexcept UNDERACT_REAL_TIME {
    const Product left = product(u[i], v[j]), right = product(u[j], v[i]);
    return (left.rounded - right.rounded) + (left.rest - right.rest);
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

double share(double part, double whole) noexcept UNDERACT_REAL_TIME {
  return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0;
}

/// Takes the point of AB nearest to q, if it is nearer than the best so far.
[[gnu::always_inline]] inline void tryEdge(const Vec3& a, const Vec3& b, const Vec3& q, Part edge, Part at_a, Part at_b,
                                           OnTriangle& best) noexcept UNDERACT_REAL_TIME {
  const Vec3 ab = b - a;
  const double t = share((q - a).dot(ab), ab.squaredNorm());
  const Vec3 p = t == 1.0 ? b : Vec3(a + t * ab);
  const double squared = (p - q).squaredNorm();
  if (squared < best.squared) best = {p, squared, t == 0.0 ? at_a : t == 1.0 ? at_b : edge};
}

/// Twice the area of the foot p with the edge AB, times |normal|. Relative to the nearer end, so that the rounding is
/// that of p's distance from it, which is small where it matters most, beyond the tip of a needle.
double areaWith(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& normal) noexcept UNDERACT_REAL_TIME {
  const Vec3 ap = p - a, bp = p - b;
  return (b - a).cross(ap.squaredNorm() <= bp.squaredNorm() ? ap : bp).dot(normal);
}

/// The foot of q, and its shares.
struct Foot {
  Vec3 p;
  double share_a, share_b, share_c;
};

/// Of a sliver over which q seems to be. Its shares are off by the rounding of its area, many times over; the way along
/// a good normal is not. Nor do shares seen from q say whether the foot is inside: an ulp of |aq|, across, is length
/// over width as much along (1e-10 of a needle of 2^-21, met from as far as it is long). So the foot itself is asked,
/// and what is then inside lies within an ulp of the triangle across and along.
[[gnu::noinline]] Foot footOnSliver(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& q,
                                    const Vec3& normal) noexcept UNDERACT_REAL_TIME {
  const Vec3 p = q - ((q - a).dot(normal) / normal.squaredNorm()) * normal;
  return {p, areaWith(b, c, p, normal), areaWith(c, a, p, normal), areaWith(a, b, p, normal)};
}

}  // namespace

OnTriangle onTriangle(const Eigen::Vector3f& p_MA, const Eigen::Vector3f& p_MB, const Eigen::Vector3f& p_MC,
                      const Vec3& q) noexcept {
  const Vec3 a = p_MA.cast<double>(), b = p_MB.cast<double>(), c = p_MC.cast<double>();
  const Vec3 ab = b - a, ac = c - a, aq = q - a;
  Vec3 normal = ab.cross(ac);
  const bool is_thin = normal.squaredNorm() < kThin * ab.squaredNorm() * ac.squaredNorm();
  if (is_thin) normal = exactCross(ab, ac);
  // Twice the areas of q's foot with each edge, times |normal|: all above 0 where the foot is inside.
  double share_b = aq.cross(ac).dot(normal), share_c = ab.cross(aq).dot(normal);
  const double whole = normal.squaredNorm();
  // Of a needle, the difference would be the rounding of the two others, as large as its length over its width.
  double share_a = is_thin ? (c - b).cross(q - b).dot(normal) : whole - share_b - share_c;
  if (share_a > 0.0 && share_b > 0.0 && share_c > 0.0) {
    if (!is_thin) {
      const Vec3 p = a + (share_b / whole) * ab + (share_c / whole) * ac;
      return {p, (p - q).squaredNorm(), Part::Inside};
    }
    const Foot foot = footOnSliver(a, b, c, q, normal);
    share_a = foot.share_a, share_b = foot.share_b, share_c = foot.share_c;
    if (share_a > 0.0 && share_b > 0.0 && share_c > 0.0) return {foot.p, (foot.p - q).squaredNorm(), Part::Inside};
  }
  OnTriangle best{a, kInfinity, Part::CornerA};
  // The foot lies beyond an edge where its share is not above 0; the nearest point is on such an edge.
  if (!(share_c > 0.0)) tryEdge(a, b, q, Part::EdgeAB, Part::CornerA, Part::CornerB, best);
  if (!(share_a > 0.0)) tryEdge(b, c, q, Part::EdgeBC, Part::CornerB, Part::CornerC, best);
  if (!(share_b > 0.0)) tryEdge(c, a, q, Part::EdgeCA, Part::CornerC, Part::CornerA, best);
  return best;
}

}  // namespace underact::mesh
