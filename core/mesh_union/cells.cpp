#include "core/mesh_union/cells.h"

#include <deque>

namespace underact::mesh_union {
namespace {

std::size_t sideFrom(const Cells::Cell& cell, std::int32_t corner) {
  return cell.corners[0] == corner ? 0 : cell.corners[1] == corner ? 1 : 2;
}

}  // namespace

Cells::Cells(Points& points, const Plane& own, const std::array<std::int32_t, 3>& domain)
    : points_(points), own_(own), axis_(axisOf(own)) {
  cells_.push_back({domain});
  put(0);
}

/// Its neighbours and corners know it again.
void Cells::put(std::int32_t index) {
  const Cell cell = at(index);
  for (std::size_t k = 0; k < 3; ++k) {
    cell_of_[cell.corners[k]] = index;
    if (cell.beside[k] < 0) continue;
    Cell& other = at(cell.beside[k]);
    const std::size_t side = sideFrom(other, cell.corners[(k + 1) % 3]);
    other.beside[side] = index;
    other.cut[side] = cell.cut[k];
  }
}

std::int32_t Cells::cellOf(std::int32_t point) {
  const auto isIn = [&](std::int32_t cell, std::size_t& beyond, std::size_t first) {
    for (std::size_t k = 0; k < 3; ++k) {
      beyond = (first + k) % 3;
      const Cell& one = at(cell);
      if (turn(one.corners[beyond], one.corners[(beyond + 1) % 3], point) < 0) return false;
    }
    return true;
  };
  std::int32_t cell = last_;
  std::size_t beyond = 0;
  for (std::size_t step = 0; step < 4 * cells_.size() + 8 && cell >= 0; ++step) {
    if (isIn(cell, beyond, step % 3)) return cell;
    cell = at(cell).beside[beyond];
  }
  for (cell = 0; cell < static_cast<std::int32_t>(cells_.size()); ++cell) {
    if (isIn(cell, beyond, 0)) return cell;
  }
  has_failed_ = true;
  return -1;
}

void Cells::add(std::int32_t point) {
  if (has_failed_ || cell_of_.contains(point)) return;
  const std::int32_t index = cellOf(point);
  if (index < 0) return;
  last_ = index;
  const Cell old = at(index);
  for (std::size_t k = 0; k < 3; ++k) {
    if (turn(old.corners[k], old.corners[(k + 1) % 3], point) == 0) {
      splitEdge({index, k}, point);
      return;
    }
  }
  const auto second = static_cast<std::int32_t>(cells_.size()), third = second + 1;
  const auto [a, b, c] = old.corners;
  cells_.resize(cells_.size() + 2);
  at(index) = {{a, b, point}, {old.beside[0], second, third}, {old.cut[0], -1, -1}};
  at(second) = {{b, c, point}, {old.beside[1], third, index}, {old.cut[1], -1, -1}};
  at(third) = {{c, a, point}, {old.beside[2], index, second}, {old.cut[2], -1, -1}};
  put(index);
  put(second);
  put(third);
}

void Cells::splitEdge(const Edge& edge, std::int32_t point) {
  const Cell old = at(edge.cell);
  const std::size_t k = edge.side, next = (k + 1) % 3, last = (k + 2) % 3;
  const std::int32_t a = old.corners[k], b = old.corners[next], c = old.corners[last], beside = old.beside[k];
  const auto second = static_cast<std::int32_t>(cells_.size());
  cells_.emplace_back();
  at(edge.cell) = {{a, point, c}, {-1, second, old.beside[last]}, {old.cut[k], -1, old.cut[last]}};
  at(second) = {{point, b, c}, {-1, old.beside[next], edge.cell}, {old.cut[k], old.cut[next], -1}};
  if (beside >= 0) {
    const Cell across = at(beside);
    const std::size_t side = sideFrom(across, b), after = (side + 1) % 3, before = (side + 2) % 3;
    const std::int32_t d = across.corners[before], third = second + 1;
    cells_.emplace_back();
    at(beside) = {{b, point, d}, {second, third, across.beside[before]}, {old.cut[k], -1, across.cut[before]}};
    at(third) = {{point, a, d}, {edge.cell, across.beside[after], beside}, {old.cut[k], across.cut[after], -1}};
    at(edge.cell).beside[0] = third;
    at(second).beside[0] = beside;
    put(third);
    put(beside);
  }
  put(edge.cell);
  put(second);
}

bool Cells::canFlip(const Edge& edge) {
  const Cell& cell = at(edge.cell);
  const std::int32_t beside = cell.beside[edge.side];
  if (beside < 0 || cell.cut[edge.side] >= 0) return false;
  const std::int32_t a = cell.corners[edge.side], b = cell.corners[(edge.side + 1) % 3],
                     c = cell.corners[(edge.side + 2) % 3];
  const std::int32_t d = at(beside).corners[(sideFrom(at(beside), b) + 2) % 3];
  return turn(a, d, c) > 0 && turn(d, b, c) > 0;
}

std::array<std::int32_t, 2> Cells::flip(const Edge& edge) {
  const Cell old = at(edge.cell);
  const std::size_t k = edge.side, next = (k + 1) % 3, last = (k + 2) % 3;
  const std::int32_t a = old.corners[k], b = old.corners[next], c = old.corners[last], beside = old.beside[k];
  const Cell across = at(beside);
  const std::size_t side = sideFrom(across, b), after = (side + 1) % 3, before = (side + 2) % 3;
  const std::int32_t d = across.corners[before];
  at(edge.cell) = {{a, d, c}, {across.beside[after], beside, old.beside[last]}, {across.cut[after], -1, old.cut[last]}};
  at(beside) = {
      {d, b, c}, {across.beside[before], old.beside[next], edge.cell}, {across.cut[before], old.cut[next], -1}};
  put(edge.cell);
  put(beside);
  return {c, d};
}

/// Its cells, each by the side that leaves the point.
std::vector<Cells::Edge> Cells::around(std::int32_t point) {
  std::vector<Edge> edges;
  const std::int32_t first = cell_of_.at(point);
  std::int32_t cell = first;
  do {
    const std::size_t side = sideFrom(at(cell), point);
    edges.push_back({cell, side});
    cell = at(cell).beside[(side + 2) % 3];
  } while (cell >= 0 && cell != first);
  if (cell == first) return edges;
  for (cell = at(first).beside[edges[0].side]; cell >= 0;) {
    const std::size_t side = sideFrom(at(cell), point);
    edges.push_back({cell, side});
    cell = at(cell).beside[side];
  }
  return edges;
}

/// From a to b or back; cell -1: they are no edge.
Cells::Edge Cells::edgeOf(std::int32_t a, std::int32_t b) {
  for (const Edge& edge : around(a)) {
    if (at(edge.cell).corners[(edge.side + 1) % 3] == b) return edge;
    if (at(edge.cell).corners[(edge.side + 2) % 3] == b) return {edge.cell, (edge.side + 2) % 3};
  }
  return {};
}

Cells::Path Cells::pathBetween(std::int32_t from, std::int32_t to) {
  Path path;
  Edge edge;
  for (const Edge& leaving : around(from)) {
    const Cell& cell = at(leaving.cell);
    const std::int32_t right = cell.corners[(leaving.side + 1) % 3], left = cell.corners[(leaving.side + 2) % 3];
    const int of_right = turn(from, right, to), of_left = turn(from, to, left);
    if (of_right < 0 || of_left < 0 || (of_right == 0 && of_left == 0)) continue;
    if (of_right == 0 || of_left == 0) {
      path.end = of_right == 0 ? right : left;
      return path;
    }
    edge = {leaving.cell, (leaving.side + 1) % 3};
    break;
  }
  while (edge.cell >= 0) {
    const Cell& cell = at(edge.cell);
    const std::int32_t right = cell.corners[edge.side], left = cell.corners[(edge.side + 1) % 3];
    if (cell.cut[edge.side] >= 0) {
      path.blocked = edge;
      return path;
    }
    path.across.push_back({right, left});
    const std::int32_t beyond = cell.beside[edge.side];
    if (beyond < 0 || path.across.size() > cells_.size()) break;
    const std::size_t side = sideFrom(at(beyond), left);  // left to right, seen from there
    const std::int32_t opposite = at(beyond).corners[(side + 2) % 3];
    const int of_opposite = opposite == to ? 0 : turn(from, to, opposite);
    if (of_opposite == 0) {
      path.end = opposite;
      return path;
    }
    // Corners there: left, right, opposite.
    edge = {beyond, of_opposite > 0 ? (side + 1) % 3 : (side + 2) % 3};
  }
  has_failed_ = true;
  return path;
}

/// Flips what the way crosses until it is an edge.
void Cells::clear(std::int32_t from, const Path& path) {
  std::deque<std::array<std::int32_t, 2>> waiting(path.across.begin(), path.across.end());
  const std::size_t max = 64 + 64 * waiting.size() * waiting.size();
  for (std::size_t step = 0; !waiting.empty(); ++step) {
    if (step > max) {
      has_failed_ = true;
      return;
    }
    const std::array<std::int32_t, 2> ends = waiting.front();
    waiting.pop_front();
    const Edge edge = edgeOf(ends[0], ends[1]);
    if (edge.cell < 0) continue;
    if (!canFlip(edge)) {
      waiting.push_back(ends);
      continue;
    }
    const auto [c, d] = flip(edge);
    const bool meets_end = c == from || d == from || c == path.end || d == path.end;
    if (!meets_end && turn(from, path.end, c) * turn(from, path.end, d) < 0) waiting.push_back({c, d});
  }
}

void Cells::mark(std::int32_t a, std::int32_t b, std::int32_t cut) {
  const Edge edge = edgeOf(a, b);
  if (edge.cell < 0) {
    has_failed_ = true;
    return;
  }
  if (at(edge.cell).cut[edge.side] >= 0) return;
  at(edge.cell).cut[edge.side] = cut;
  put(edge.cell);
}

void Cells::constrain(std::int32_t from, std::int32_t to, const Plane& plane) {
  const auto cut = static_cast<std::int32_t>(cuts_.size());
  cuts_.push_back(plane);
  std::vector<std::array<std::int32_t, 2>> waiting{{from, to}};
  while (!waiting.empty() && !has_failed_) {
    const auto [a, b] = waiting.back();
    waiting.pop_back();
    if (a == b) continue;
    if (const Edge edge = edgeOf(a, b); edge.cell >= 0) {
      mark(a, b, cut);
      continue;
    }
    const Path path = pathBetween(a, b);
    if (has_failed_) return;
    if (path.blocked.cell >= 0) {
      const Plane& other = cuts_[static_cast<std::size_t>(at(path.blocked.cell).cut[path.blocked.side])];
      const std::int32_t crossing = points_.ofPlanes(own_, plane, other);
      has_failed_ = crossing < 0 || cell_of_.contains(crossing);
      if (has_failed_) return;
      splitEdge(path.blocked, crossing);
      waiting.push_back({crossing, b});
      waiting.push_back({a, crossing});
      continue;
    }
    clear(a, path);
    if (has_failed_) return;
    mark(a, path.end, cut);
    waiting.push_back({path.end, b});
  }
}

void Cells::improve() {
  constexpr int kPasses = 6;
  const auto isFlat = [&](const Edge& edge) {  // the two angles across the edge are more than half a turn together
    const Cell& cell = at(edge.cell);
    const std::int32_t b = cell.corners[(edge.side + 1) % 3];
    const Cell& across = at(cell.beside[edge.side]);
    const Vec3 &pa = points_.near(cell.corners[edge.side]), &pb = points_.near(b);
    const auto at_corner = [&](std::int32_t corner) {
      const Vec3 to_a = pa - points_.near(corner), to_b = pb - points_.near(corner);
      return std::array<double, 2>{to_a.dot(to_b), to_a.cross(to_b).norm()};
    };
    const auto one = at_corner(cell.corners[(edge.side + 2) % 3]),
               other = at_corner(across.corners[(sideFrom(across, b) + 2) % 3]);
    const double sum = one[0] * other[1] + other[0] * one[1];
    const double size = std::abs(one[0] * other[1]) + std::abs(other[0] * one[1]) + one[1] * other[1];
    return sum < -1e-9 * size;
  };
  for (int pass = 0; pass < kPasses && !has_failed_; ++pass) {
    bool any = false;
    for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(cells_.size()); ++cell) {
      for (std::size_t side = 0; side < 3; ++side) {
        const Edge edge{cell, side};
        if (at(cell).beside[side] < 0 || at(cell).cut[side] >= 0 || !isFlat(edge) || !canFlip(edge)) continue;
        flip(edge);
        any = true;
      }
    }
    if (!any) return;
  }
}

}  // namespace underact::mesh_union
