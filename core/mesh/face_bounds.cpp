#include "core/mesh/face_bounds.h"

namespace underact::mesh {
namespace {

/// Four floats, one for each face. Their operators are those of floats, on every processor.
using Four = float __attribute__((vector_size(4 * kAtOnce)));

Four fourOf(float x) noexcept UNDERACT_REAL_TIME {
  return Four{x, x, x, x};
}
/// The lesser, y where one is not a number; the greater likewise below.
Four lesser(Four x, Four y) noexcept UNDERACT_REAL_TIME {
  return x < y ? x : y;
}
Four greater(Four x, Four y) noexcept UNDERACT_REAL_TIME {
  return x > y ? x : y;
}

struct Vec3s {
  Four x, y, z;
};
Vec3s operator+(const Vec3s& u, const Vec3s& v) noexcept UNDERACT_REAL_TIME {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
Vec3s operator-(const Vec3s& u, const Vec3s& v) noexcept UNDERACT_REAL_TIME {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
Vec3s operator*(Four s, const Vec3s& v) noexcept UNDERACT_REAL_TIME {
  return {s * v.x, s * v.y, s * v.z};
}
Four dot(const Vec3s& u, const Vec3s& v) noexcept UNDERACT_REAL_TIME {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
Vec3s cross(const Vec3s& u, const Vec3s& v) noexcept UNDERACT_REAL_TIME {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// The squared distance from 0 to the edge from p along e.
[[gnu::always_inline]] inline Four squaredToEdge(const Vec3s& p, const Vec3s& e,
                                                 Four e_squared) noexcept UNDERACT_REAL_TIME {
  const Four none = fourOf(0.0F);
  const Four share = lesser(greater((none - dot(p, e)) / e_squared, none), fourOf(1.0F));
  const Vec3s nearest = p + share * e;
  return dot(nearest, nearest);
}

[[gnu::always_inline]] inline Vec3s cornersAt(const Surface& surface, const std::array<std::int32_t, kAtOnce>& faces,
                                              std::size_t corner) noexcept UNDERACT_REAL_TIME {
  const auto at = [&](std::size_t k) noexcept UNDERACT_REAL_TIME -> const Eigen::Vector3f& {
    const Face& face = surface.triangles.faces[static_cast<std::size_t>(faces[k])];
    return surface.triangles.p_MV[static_cast<std::size_t>(face[corner])];
  };
  const Eigen::Vector3f &p = at(0), &q = at(1), &r = at(2), &s = at(3);
  return {Four{p.x(), q.x(), r.x(), s.x()}, Four{p.y(), q.y(), r.y(), s.y()}, Four{p.z(), q.z(), r.z(), s.z()}};
}

}  // namespace

// With u = 2^-24, M the distance of the farthest corner, L the longest edge and A the angle at a: edges are off by u of
// themselves, their cross product by 5.3 u |ab| |ac|, so its direction by 5.3 u / sin A < 43 u, as sin A > 1/8. So the
// distance from the plane, those from the edges, and the places at which the foot is taken to go over an edge are each
// off by less than 64 u M. The distance found, d, is then above the true one by e < 2^-17 M at most, and
// (d - e)^2 >= (1 - s) d^2 - e^2 / s, and M^2 <= 2 d^2 + 2 L^2: for s = 2^-17 no more than 2^-15 d^2 and 2^-16 L^2 are
// to be taken off. Twice as much is.
std::array<float, kAtOnce> faceBounds(const Surface& surface, const std::array<std::int32_t, kAtOnce>& faces,
                                      const Vec3& q_M) noexcept {
  constexpr float kLess = 1.0F - 0x1p-14F, kOfEdge = 0x1p-15F, kSharp = 0x1p-6F;
  constexpr float kSmallest = 0x1p-100F, kLargest = 0x1p100F;
  const Eigen::Vector3f high = q_M.cast<float>(), low = (q_M - high.cast<double>()).cast<float>();
  const Vec3s q_high{fourOf(high.x()), fourOf(high.y()), fourOf(high.z())};
  const Vec3s q_low{fourOf(low.x()), fourOf(low.y()), fourOf(low.z())};
  const Vec3s a_M = cornersAt(surface, faces, 0), b_M = cornersAt(surface, faces, 1),
              c_M = cornersAt(surface, faces, 2);
  // Edges by the corners, to the last bit; relative to q, short ones would cancel.
  const Vec3s ab = b_M - a_M, ac = c_M - a_M, bc = c_M - b_M;
  const Vec3s a = (a_M - q_high) - q_low, b = a + ab;
  const Four ab_squared = dot(ab, ab), ac_squared = dot(ac, ac), bc_squared = dot(bc, bc);
  const Vec3s normal = cross(ab, ac);
  const Four normal_squared = dot(normal, normal), height = dot(a, normal);
  const Four to_plane = height / normal_squared * height;
  const Four to_edges = lesser(lesser(squaredToEdge(a, ab, ab_squared), squaredToEdge(a, ac, ac_squared)),
                               squaredToEdge(b, bc, bc_squared));
  const Four none = fourOf(0.0F);
  const Four min_share =
      lesser(lesser(dot(cross(a, ab), normal), dot(cross(ac, a), normal)), dot(cross(b, bc), normal));
  const Four squared = min_share > none ? to_plane : to_edges;
  const Four longest = greater(greater(ab_squared, ac_squared), bc_squared);
  // The remainder of splitting q, 2^-47 of it, and what squares of floats cannot represent.
  const float rest = 0x1p-74F * high.squaredNorm() + kSmallest;
  const Four bound = squared * fourOf(kLess) - longest * fourOf(kOfEdge) - fourOf(rest);
  const Four smallest = lesser(normal_squared, lesser(ab_squared, ac_squared));
  const Four floor = smallest > fourOf(kSmallest) ? fourOf(kSharp) * ab_squared * ac_squared : fourOf(kLargest);
  Four known = normal_squared > floor ? bound : none;
  known = normal_squared < fourOf(kLargest) ? known : none;
  known = squared < fourOf(kLargest) ? known : none;
  return {known[0], known[1], known[2], known[3]};
}

}  // namespace underact::mesh
