#include "core/mesh_union/points.h"

#include <cmath>

namespace underact::mesh_union {
namespace {

/// A number of the point itself, whatever its homogeneous coordinates are multiplied by.
std::uint64_t keyOf(const std::array<std::uint64_t, 3>& xyz, std::uint64_t w) {
  const std::uint64_t inverse = w == 1 ? 1 : inverseModulo(w);
  std::uint64_t key = 0;
  for (const std::uint64_t coordinate : xyz) {
    key = (key ^ timesModulo(coordinate, inverse)) * 0x9E37'79B9'7F4A'7C15U;
    key ^= key >> 32U;
  }
  return key;
}

Big bigOf(std::int64_t value) {
  return {static_cast<Wide>(value)};
}

/// a1 b2 - a2 b1.
Big minor(const Big& a1, const Big& a2, const Big& b1, const Big& b2) {
  return a1 * b2 - a2 * b1;
}

}  // namespace

Points::Points(const Grid& grid) : grid_(grid) {
  of_corner_.reserve(grid.points.size());
  near_.reserve(grid.points.size());
  known_.reserve(grid.points.size());
  const auto residue = [](std::int64_t value) {
    return value < 0 ? kModulus - static_cast<std::uint64_t>(-value) : static_cast<std::uint64_t>(value);
  };
  for (std::size_t corner = 0; corner < grid.points.size(); ++corner) {
    const GridPoint& p = grid.points[corner];
    near_.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
    auto point = static_cast<std::int32_t>(corner);
    const std::uint64_t key = keyOf({residue(p[0]), residue(p[1]), residue(p[2])}, 1);
    const auto [begin, end] = known_.equal_range(key);
    bool is_new = true;
    for (auto one = begin; one != end && is_new; ++one) {
      is_new = grid.points[static_cast<std::size_t>(one->second)] != p;
      if (!is_new) point = one->second;
    }
    if (is_new) known_.emplace(key, point);
    of_corner_.push_back(point);
  }
}

Points::Exact Points::exact(std::int32_t point) const {
  const auto index = static_cast<std::size_t>(point);
  if (index >= grid_.points.size()) return made_[index - grid_.points.size()];
  const GridPoint& p = grid_.points[index];
  return {bigOf(p[0]), bigOf(p[1]), bigOf(p[2]), bigOf(1)};
}

std::int32_t Points::add(Exact point) {
  if (point.w.sign() < 0) point = {-point.x, -point.y, -point.z, -point.w};
  const std::uint64_t key = keyOf({point.x.modulo(), point.y.modulo(), point.z.modulo()}, point.w.modulo());
  const auto [begin, end] = known_.equal_range(key);
  for (auto one = begin; one != end; ++one) {
    const Exact other = exact(one->second);
    const auto same = [&](const Big& a, const Big& b) { return (a * other.w - b * point.w).sign() == 0; };
    if (same(point.x, other.x) && same(point.y, other.y) && same(point.z, other.z)) return one->second;
  }
  const std::int32_t number = append(point);
  known_.emplace(key, number);
  return number;
}

std::int32_t Points::append(const Exact& point) {
  const double w = point.w.toDouble();
  near_.emplace_back(point.x.toDouble() / w, point.y.toDouble() / w, point.z.toDouble() / w);
  made_.push_back(point);
  return static_cast<std::int32_t>(near_.size() - 1);
}

std::int32_t Points::beside(const GridPoint& p) {
  return append({bigOf(p[0]), bigOf(p[1]), bigOf(p[2]), bigOf(1)});
}

std::int32_t Points::onEdge(std::int32_t p, std::int32_t q, const Plane& plane) {
  const GridPoint& from = grid_.points[static_cast<std::size_t>(p)];
  const GridPoint& to = grid_.points[static_cast<std::size_t>(q)];
  const Big at_from(heightOf(plane, from)), at_to(heightOf(plane, to));
  const auto along = [&](std::size_t k) { return bigOf(from[k]) * at_to - bigOf(to[k]) * at_from; };
  return add({along(0), along(1), along(2), at_to - at_from});
}

std::int32_t Points::ofPlanes(const Plane& a, const Plane& b, const Plane& c) {
  std::array<std::array<Big, 3>, 3> n;
  const std::array<Big, 3> d{Big(a.d), Big(b.d), Big(c.d)};
  for (std::size_t k = 0; k < 3; ++k) n[0][k] = bigOf(a.n[k]), n[1][k] = bigOf(b.n[k]), n[2][k] = bigOf(c.n[k]);
  // Cramer's rule, along the rows of cofactors of b and c, c and a, a and b.
  std::array<std::array<Big, 3>, 3> cofactors;
  for (std::size_t row = 0; row < 3; ++row) {
    const auto& u = n[(row + 1) % 3];
    const auto& v = n[(row + 2) % 3];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      cofactors[row][k] = minor(u[i], u[j], v[i], v[j]);
    }
  }
  const auto sum = [&](std::size_t k) {
    return d[0] * cofactors[0][k] + d[1] * cofactors[1][k] + d[2] * cofactors[2][k];
  };
  const Big w = n[0][0] * cofactors[0][0] + n[0][1] * cofactors[0][1] + n[0][2] * cofactors[0][2];
  return w.sign() == 0 ? -1 : add({sum(0), sum(1), sum(2), w});
}

int Points::turn(std::size_t axis, std::int32_t a, std::int32_t b, std::int32_t c) const {
  const auto u = static_cast<Eigen::Index>((axis + 1) % 3), v = static_cast<Eigen::Index>((axis + 2) % 3);
  const Vec3& pa = near(a);
  const Vec3 ab = near(b) - pa, ac = near(c) - pa;
  const double area = ab[u] * ac[v] - ab[v] * ac[u];
  // Each difference is off by 2^-22 at most, and its products by as much of the other one.
  const double rounding = 0x1p-21 * (std::abs(ab[u]) + std::abs(ab[v]) + std::abs(ac[u]) + std::abs(ac[v]) + 1.0) +
                          0x1p-50 * (std::abs(ab[u] * ac[v]) + std::abs(ab[v] * ac[u]));
  if (std::abs(area) > rounding) return area > 0.0 ? 1 : -1;
  const auto flat = [&](std::int32_t point) {
    const Exact e = exact(point);
    const std::array<const Big*, 3> xyz{&e.x, &e.y, &e.z};
    return std::array<Big, 3>{*xyz[static_cast<std::size_t>(u)], *xyz[static_cast<std::size_t>(v)], e.w};
  };
  const std::array<Big, 3> p = flat(a), q = flat(b), r = flat(c);
  return (p[0] * minor(q[1], q[2], r[1], r[2]) - p[1] * minor(q[0], q[2], r[0], r[2]) +
          p[2] * minor(q[0], q[1], r[0], r[1]))
      .sign();
}

}  // namespace underact::mesh_union
