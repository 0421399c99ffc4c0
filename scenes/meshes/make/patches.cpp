#include "scenes/meshes/make/patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace underact::mesh_maker {
namespace {

using Corners = std::vector<Eigen::Vector3f>;

void appendCorners(const Patch& patch, Corners& corners) {
  // A zero has no sign here: -0 and 0 are the same place, but not the same bytes.
  const auto at = [&](int i, int j) -> Eigen::Vector3f { return patch.at(i, j).cast<float>().array() + 0.0F; };
  for (int i = 0; i < patch.across; ++i) {
    for (int j = 0; j < (patch.half ? patch.across - i : patch.along); ++j) {
      corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i, j + 1)});
      if (patch.half && i + j + 1 == patch.across) continue;
      corners.insert(corners.end(), {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

}  // namespace

int facesOf(const std::vector<Patch>& patches) {
  return std::accumulate(patches.begin(), patches.end(), 0,
                         [](int sum, const Patch& patch) { return sum + patch.faces(); });
}

mesh::Triangles joined(const std::vector<Patch>& patches) {
  Corners corners;
  corners.reserve(3 * static_cast<std::size_t>(facesOf(patches)));
  for (const Patch& patch : patches) appendCorners(patch, corners);
  std::vector<std::size_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::size_t i) {
    const Eigen::Vector3f& p = corners[i];
    return std::make_tuple(p.x(), p.y(), p.z());
  };
  std::sort(order.begin(), order.end(), [&](std::size_t left, std::size_t right) {
    return std::make_pair(key(left), left) < std::make_pair(key(right), right);
  });
  std::vector<std::size_t> first(corners.size());  // of the corners at this one's place
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  mesh::Triangles made;
  std::vector<std::int32_t> number(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (first[i] == i) {
      number[i] = static_cast<std::int32_t>(made.p_MV.size());
      made.p_MV.push_back(corners[i]);
    } else {
      number[i] = number[first[i]];
    }
    if (i % 3 == 2) made.faces.push_back({number[i - 2], number[i - 1], number[i]});
  }
  return made;
}

mesh::Triangles ofFaces(int faces, double area_mm2, const std::function<std::vector<Patch>(double cell_mm)>& patches) {
  const double even_mm = std::sqrt(2.0 * area_mm2 / faces);
  std::vector<Patch> best;
  for (int step = -100; step <= 100; ++step) {  // lengths are cut a whole number of times: not every count can be met
    std::vector<Patch> one = patches(even_mm * (1.0 + 0.004 * step));
    if (best.empty() || std::abs(facesOf(one) - faces) < std::abs(facesOf(best) - faces)) best = std::move(one);
  }
  return joined(best);
}

int cuts(double length_mm, double cell_mm) {
  return std::max(1, static_cast<int>(std::lround(length_mm / cell_mm)));
}

Ruler::Ruler(const std::vector<double>& breaks, const std::vector<int>& cuts) {
  for (std::size_t part = 0; part < cuts.size(); ++part) {
    starts.push_back(static_cast<int>(points.size()));
    const int n = cuts[part];
    for (int i = 0; i < n; ++i) points.push_back((breaks[part] * (n - i) + breaks[part + 1] * i) / n);
  }
  starts.push_back(static_cast<int>(points.size()));
  points.push_back(breaks.back());
}

Vec3 Rulers::at(int u, int v, double on_u, double on_v, double w) const {
  Vec3 p_MV = Vec3::Constant(w);
  p_MV[u] = on_u;
  p_MV[v] = on_v;
  return p_MV;
}

Patch Rulers::flat(int u, int v, double w, Parts u_parts, Parts v_parts) const {
  const auto bounds = [&](int axis, Parts parts) {
    const std::vector<int>& starts = ruler(axis).starts;
    return std::make_pair(starts[static_cast<std::size_t>(parts.from)], starts[static_cast<std::size_t>(parts.to)]);
  };
  const auto [u0, u1] = bounds(u, u_parts);
  const auto [v0, v1] = bounds(v, v_parts);
  return {u1 - u0, v1 - v0, false, [this, u, v, w, u_begin = u0, v_begin = v0](int i, int j) {
            return at(u, v, ruler(u).points[static_cast<std::size_t>(u_begin + i)],
                      ruler(v).points[static_cast<std::size_t>(v_begin + j)], w);
          }};
}

/// Once around the parts, counterclockwise.
std::vector<Eigen::Vector2d> Rulers::rim(int u, int v, Parts u_parts, Parts v_parts) const {
  const Patch cells = flat(u, v, 0.0, u_parts, v_parts);
  std::vector<Eigen::Vector2d> around;
  const auto add = [&](int i, int j) {
    const Vec3 p = cells.at(i, j);
    around.emplace_back(p[u], p[v]);
  };
  for (int i = 0; i < cells.across; ++i) add(i, 0);
  for (int j = 0; j < cells.along; ++j) add(cells.across, j);
  for (int i = cells.across; i > 0; --i) add(i, cells.along);
  for (int j = cells.along; j > 0; --j) add(0, j);
  return around;
}

/// Where the line from the hole's centre to a point of the rim meets the hole: lines from one point cross nowhere else.
Eigen::Vector2d Rulers::onHole(int u, int v, Parts u_parts, Parts v_parts, double radius_mm,
                               const Eigen::Vector2d& rim) const {
  const auto middle = [&](int axis, Parts parts) {
    const Ruler& along = ruler(axis);
    const auto at = [&](int part) {
      return along.points[static_cast<std::size_t>(along.starts[static_cast<std::size_t>(part)])];
    };
    return 0.5 * (at(parts.from) + at(parts.to));
  };
  const Eigen::Vector2d centre(middle(u, u_parts), middle(v, v_parts));
  const Eigen::Vector2d off = rim - centre;
  const double shrink = radius_mm / std::sqrt(off.x() * off.x() + off.y() * off.y());
  return centre + shrink * off;
}

Patch Rulers::ring(int u, int v, double w, Parts u_parts, Parts v_parts, double radius_mm, int along) const {
  const std::vector<Eigen::Vector2d> around = rim(u, v, u_parts, v_parts);
  const int across = static_cast<int>(around.size());
  return {across, along, false, [=, this](int i, int j) {
            const Eigen::Vector2d& outer = around[static_cast<std::size_t>(i % across)];
            const Eigen::Vector2d inner = onHole(u, v, u_parts, v_parts, radius_mm, outer);
            const double share = static_cast<double>(j) / along;
            const Eigen::Vector2d p = j == 0       ? outer
                                      : j == along ? inner
                                                   : Eigen::Vector2d(outer + share * (inner - outer));
            return at(u, v, p.x(), p.y(), w);
          }};
}

Patch Rulers::holeWall(int u, int v, Parts w_parts, Parts u_parts, Parts v_parts, double radius_mm) const {
  const std::vector<Eigen::Vector2d> around = rim(u, v, u_parts, v_parts);
  const int across = static_cast<int>(around.size()), w = 3 - u - v;
  const int from = ruler(w).starts[static_cast<std::size_t>(w_parts.from)];
  const int to = ruler(w).starts[static_cast<std::size_t>(w_parts.to)];
  return {across, to - from, false, [=, this](int i, int j) {  // downwards, so that outside is at the hole's axis
            const Eigen::Vector2d p =
                onHole(u, v, u_parts, v_parts, radius_mm, around[static_cast<std::size_t>(i % across)]);
            return at(u, v, p.x(), p.y(), ruler(w).points[static_cast<std::size_t>(to - j)]);
          }};
}

}  // namespace underact::mesh_maker
