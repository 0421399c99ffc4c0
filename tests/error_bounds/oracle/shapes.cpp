#include "tests/error_bounds/oracle/shapes.h"

namespace underact::error_bounds::oracle {
namespace {

Nearest at(const Real3& p_WP, const Real3& p_WT) {
  return {p_WP, norm(p_WP - p_WT)};
}

const Nearest& nearer(const Nearest& a, const Nearest& b) {
  return b.distance < a.distance ? b : a;
}

/// Any direction at right angles to the axis.
Real3 anyAcross(const Real3& axis) {
  const bool x_min = abs(axis.x) <= abs(axis.y) && abs(axis.x) <= abs(axis.z);
  const Real3 other = x_min ? Real3{1, 0, 0} : abs(axis.y) <= abs(axis.z) ? Real3{0, 1, 0} : Real3{0, 0, 1};
  return unit(cross(axis, other));
}

}  // namespace

Nearest onSphere(const Real3& p_WC, const Real& radius, const Real3& p_WT) {
  const Real3 away = p_WT - p_WC;
  const Real length = norm(away);
  return at(p_WC + (length > 0 ? Real(radius / length) * away : Real3{radius, 0, 0}), p_WT);
}

Nearest onLine(const Real3& p_WC, const Real3& axis_W, const Real3& p_WT) {
  return at(p_WC + Real(dot(p_WT - p_WC, axis_W) / dot(axis_W, axis_W)) * axis_W, p_WT);
}

Nearest onPlane(const Real3& p_WC, const Real3& normal_W, const Real3& p_WT) {
  return at(p_WT - Real(dot(p_WT - p_WC, normal_W) / dot(normal_W, normal_W)) * normal_W, p_WT);
}

Real offAxis(const Real3& p_WC, const Real3& axis_W, const Real3& p_WT) {
  return norm(cross(p_WT - p_WC, axis_W)) / norm(axis_W);
}

Nearest onCircle(const Real3& p_WC, const Real3& axis_W, const Real& radius, const Real3& p_WT) {
  // By two cross products: at right angles to the axis, then back into the plane of axis and tip.
  const Real3 out = cross(axis_W, cross(p_WT - p_WC, axis_W));
  const Real length = norm(out);
  return at(p_WC + (length > 0 ? Real(radius / length) * out : radius * anyAcross(axis_W)), p_WT);
}

Nearest onCylinder(const Real3& p_WC, const Real3& axis_W, const Real& radius, const Real3& p_WT) {
  return onCircle(onLine(p_WC, axis_W, p_WT).p_WP, axis_W, radius, p_WT);
}

Nearest onSegment(const Real3& a, const Real3& b, const Real3& q) {
  const Real3 heading = b - a;
  const Real squared = dot(heading, heading);
  if (squared == 0) return at(a, q);
  return at(a + clamped(Real(dot(q - a, heading) / squared), 0, 1) * heading, q);
}

Nearest onTriangle(const Real3& a, const Real3& b, const Real3& c, const Real3& q) {
  Nearest best = nearer(nearer(onSegment(a, b, q), onSegment(b, c, q)), onSegment(c, a, q));
  const Real3 normal = cross(b - a, c - a);
  if (dot(normal, normal) == 0) return best;
  const Nearest foot = onPlane(a, normal, q);
  const auto isLeftOf = [&](const Real3& from, const Real3& to) {
    return dot(cross(to - from, foot.p_WP - from), normal) >= 0;
  };
  return isLeftOf(a, b) && isLeftOf(b, c) && isLeftOf(c, a) ? foot : best;
}

Real shareOfSphere(const Real3& a, const Real3& b, const Real3& c, const Real3& q) {
  const Real3 x = a - q, y = b - q, z = c - q;
  const Real lx = norm(x), ly = norm(y), lz = norm(z);
  const Real volume = dot(x, cross(y, z));
  const Real along = lx * ly * lz + dot(x, y) * lz + dot(y, z) * lx + dot(z, x) * ly;
  return atan2(volume, along) / (2 * piReal());
}

Nearest onParallelogram(const Real3& c, const Real3& u, const Real3& v, const Real3& q) {
  const Real3 first = c - u - v, second = c + u - v, third = c + u + v, fourth = c - u + v;
  return nearer(onTriangle(first, second, third, q), onTriangle(first, third, fourth, q));
}

Nearest onSolid(const Real3& c, const std::array<Real3, 3>& edges, const Real3& q) {
  Nearest best = onParallelogram(c + edges[0], edges[1], edges[2], q);
  for (std::size_t face = 1; face < 6; ++face) {
    const Real3& out = edges[face / 2];
    const Real3 middle = face % 2 == 0 ? c + out : c - out;
    best = nearer(best, onParallelogram(middle, edges[(face / 2 + 1) % 3], edges[(face / 2 + 2) % 3], q));
  }
  return best;
}

bool isInSolid(const Real3& c, const std::array<Real3, 3>& edges, const Real3& q) {
  const Real volume = dot(edges[0], cross(edges[1], edges[2]));
  for (std::size_t i = 0; i < 3; ++i) {
    if (abs(dot(q - c, cross(edges[(i + 1) % 3], edges[(i + 2) % 3]))) >= abs(volume)) return false;
  }
  return true;
}

Real toQuadric(const std::array<Real, 3>& semi, const std::array<Real, 3>& y, int count) {
  const auto end = static_cast<std::size_t>(count);
  Real min = semi[0], beyond = 0;
  for (std::size_t i = 1; i < end; ++i) min = std::min(min, semi[i]);
  // x_i = semi_i^2 y_i / (semi_i^2 + t); on the shape for one t above -least^2, except in the middle of the thin axes,
  // where the sum stays below 1 up to there and the remainder goes along a thin axis.
  const Real pole = -min * min;
  // By s = t + least^2, which may be 1e-300 of it.
  const auto sumAt = [&](const Real& s) {
    Real sum = -1;
    for (std::size_t i = 0; i < end; ++i) {
      if (y[i] == 0) continue;
      const Real share = semi[i] * y[i] / (semi[i] * semi[i] + pole + s);
      sum += share * share;
    }
    return sum;
  };
  bool is_thin = true;  // nothing along a thinnest axis
  Real aside = 0, size = 0;
  for (std::size_t i = 0; i < end; ++i) {
    size += abs(semi[i] * y[i]);
    if (semi[i] == min) {
      is_thin = is_thin && y[i] == 0;
      continue;
    }
    const Real x = semi[i] * semi[i] * y[i] / (semi[i] * semi[i] + pole);
    beyond += (x / semi[i]) * (x / semi[i]);
    aside += (x - y[i]) * (x - y[i]);
  }
  if (is_thin && beyond <= 1) return sqrt(aside + min * min * (1 - beyond));
  // Bisects the logarithm of s, which spans from below the rounding of a hundred digits up to size.
  Real low = ldexp(min * min, -2300), high = 2 * size + min * min;
  while (sumAt(high) > 0) high *= 4;
  for (int step = 0; step < 400 && high > low * (1 + ldexp(Real(1), -40)); ++step) {
    const Real middle = sqrt(low * high);
    (sumAt(middle) > 0 ? low : high) = middle;
  }
  Real s = low;
  for (int step = 0; step < 6; ++step) {  // the sum decreases and is convex: from the left Newton does not overshoot
    Real slope = 0;
    for (std::size_t i = 0; i < end; ++i) {
      if (y[i] == 0) continue;
      const Real share = semi[i] * y[i] / (semi[i] * semi[i] + pole + s);
      slope += 2 * share * share / (semi[i] * semi[i] + pole + s);
    }
    if (slope == 0) break;
    s += sumAt(s) / slope;
  }
  Real squared = 0;
  for (std::size_t i = 0; i < end; ++i) {
    if (y[i] == 0) continue;
    const Real off = semi[i] * semi[i] * y[i] / (semi[i] * semi[i] + pole + s) - y[i];
    squared += off * off;
  }
  return sqrt(squared);
}

std::array<Real3, 3> axesOf(const Mat3& R) {
  const Real3 x = unit(real(R.col(0))), y = unit(without(real(R.col(1)), x));
  const Real3 z = cross(x, y);
  return {x, y, dot(z, real(R.col(2))) < 0 ? Real(-1) * z : z};
}

}  // namespace underact::error_bounds::oracle
