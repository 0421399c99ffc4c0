#include "core/mesh/on_triangle.h"

#include <algorithm>

namespace underact::mesh {
namespace {

/// Square of the sine between two edges below which a triangle is a sliver: there shares lose a third of their digits.
constexpr double kThin = 1e-10;

double share(double part, double whole) noexcept UNDERACT_REAL_TIME {
  return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0;
}

/// The point of AB nearest to q, where it is nearer than what was found so far.
void tryEdge(const Vec3& a, const Vec3& b, const Vec3& q, Part edge, Part at_a, Part at_b,
             OnTriangle& best) noexcept UNDERACT_REAL_TIME {
  const Vec3 ab = b - a;
  const double t = share((q - a).dot(ab), ab.squaredNorm());
  const Vec3 p = t == 1.0 ? b : Vec3(a + t * ab);
  const double squared = (p - q).squaredNorm();
  if (squared < best.squared) best = {p, squared, t == 0.0 ? at_a : t == 1.0 ? at_b : edge};
}

}  // namespace

OnTriangle onTriangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& q) noexcept {
  const Vec3 ab = b - a, ac = c - a, aq = q - a;
  const Vec3 normal = ab.cross(ac);
  // Twice the areas of q's foot with each edge, times |normal|: all above 0 where the foot is inside.
  const double at_b = aq.cross(ac).dot(normal), at_c = ab.cross(aq).dot(normal);
  const double whole = normal.squaredNorm();
  const double at_a = whole - at_b - at_c;
  if (at_a > 0.0 && at_b > 0.0 && at_c > 0.0) {
    Vec3 p = a + (at_b / whole) * ab + (at_c / whole) * ac;
    if (whole < kThin * ab.squaredNorm() * ac.squaredNorm()) {
      // The shares of a sliver are off by the rounding of its area; what is left of the way to the foot is not.
      const Vec3 pq = q - p;
      p += (pq.cross(ac).dot(normal) / whole) * ab + (ab.cross(pq).dot(normal) / whole) * ac;
    }
    return {p, (p - q).squaredNorm(), Part::Inside};
  }
  OnTriangle best{a, kInfinity, Part::CornerA};
  // The foot lies beyond an edge where its share is not above 0; the nearest point is on such an edge.
  if (!(at_c > 0.0)) tryEdge(a, b, q, Part::EdgeAB, Part::CornerA, Part::CornerB, best);
  if (!(at_a > 0.0)) tryEdge(b, c, q, Part::EdgeBC, Part::CornerB, Part::CornerC, best);
  if (!(at_b > 0.0)) tryEdge(c, a, q, Part::EdgeCA, Part::CornerC, Part::CornerA, best);
  return best;
}

}  // namespace underact::mesh
