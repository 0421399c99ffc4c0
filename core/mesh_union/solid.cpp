#include "core/mesh_union/solid.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/trig.h"

namespace underact::mesh_union {
namespace {

class Corners {
 public:
  explicit Corners(std::size_t pieces) : of_(3 * pieces) { std::iota(of_.begin(), of_.end(), 0); }
  std::int32_t lead(std::int32_t corner) {
    while (of_[static_cast<std::size_t>(corner)] != corner) {
      std::int32_t& next = of_[static_cast<std::size_t>(corner)];
      next = of_[static_cast<std::size_t>(next)];
      corner = next;
    }
    return corner;
  }
  /// Both ends of the edge that they share.
  void join(const PieceSide& one, const PieceSide& other) {
    const auto at = [](const PieceSide& side, int k) { return 3 * side.piece + (side.side + k) % 3; };
    join(at(one, 0), at(other, 1));
    join(at(one, 1), at(other, 0));
  }

 private:
  void join(std::int32_t a, std::int32_t b) {
    a = lead(a), b = lead(b);
    of_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  std::vector<std::int32_t> of_;
};

/// Its pieces around the edge, counterclockwise as seen from its high end.
std::vector<const PieceSide*> around(const PieceSide* first, const PieceSide* last, const std::vector<Piece>& pieces,
                                     const Points& points) {
  const Vec3& low = points.near(first->low);
  const Vec3 axis = (points.near(first->high) - low).stableNormalized();
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<std::pair<double, const PieceSide*>> turned;
  for (const PieceSide* side = first; side != last; ++side) {
    const Piece& piece = pieces[static_cast<std::size_t>(side->piece)];
    const Vec3 to = points.near(piece.corners[static_cast<std::size_t>((side->side + 2) % 3)]) - low;
    turned.emplace_back(atan2Of(to.dot(v), to.dot(u)), side);
  }
  std::stable_sort(turned.begin(), turned.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const PieceSide*> sides;
  for (const auto& [angle_rad, side] : turned) sides.push_back(side);
  return sides;
}

/// Two sides that belong together.
struct Pair {
  PieceSide one, other;
};

/// Those on an edge of more than two, outside by outside.
void addPairs(const PieceSide* first, const PieceSide* last, const std::vector<Piece>& pieces, const Points& points,
              std::vector<Pair>& pairs) {
  // The outside is counterclockwise of a piece that goes forward along the edge, up to the next one that goes back.
  std::vector<const PieceSide*> left = around(first, last, pieces, points);
  while (left.size() >= 2) {
    std::size_t k = 0;
    while (k < left.size() && !(left[k]->forward && !left[(k + 1) % left.size()]->forward)) ++k;
    if (k == left.size()) break;
    const std::size_t next = (k + 1) % left.size();
    pairs.push_back({*left[k], *left[next]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(std::max(k, next)));
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(std::min(k, next)));
  }
}

class Building {
 public:
  Building(const std::vector<Piece>& pieces, Corners& corners) : faces_of_(pieces.size()) {
    std::vector<std::int32_t> number(3 * pieces.size(), -1);
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
      mesh::Face face{};
      for (std::size_t k = 0; k < 3; ++k) {
        std::int32_t& corner = number[static_cast<std::size_t>(corners.lead(static_cast<std::int32_t>(3 * piece + k)))];
        if (corner < 0) {
          corner = static_cast<std::int32_t>(solid_.between.size());
          solid_.between.push_back({pieces[piece].corners[k], pieces[piece].corners[k]});
        }
        face[k] = corner;
      }
      add(face, static_cast<std::int32_t>(piece));
    }
    whole_ = solid_.faces;
  }

  std::array<std::int32_t, 2> endsOf(const PieceSide& side) const {
    const mesh::Face& face = whole_[static_cast<std::size_t>(side.piece)];
    const auto k = static_cast<std::size_t>(side.side);
    return {face[k], face[(k + 1) % 3]};
  }

  /// A corner in the middle of the edge of a pair.
  void halve(const Pair& pair) {
    const auto middle = static_cast<std::int32_t>(solid_.between.size());
    solid_.between.push_back({pair.one.low, pair.one.high});
    halve(pair.one, middle);
    halve(pair.other, middle);
  }

  Solid take() { return std::move(solid_); }

 private:
  void add(const mesh::Face& face, std::int32_t piece) {
    faces_of_[static_cast<std::size_t>(piece)].push_back(static_cast<std::int32_t>(solid_.faces.size()));
    solid_.faces.push_back(face);
    solid_.piece_of.push_back(piece);
  }
  void halve(const PieceSide& side, std::int32_t middle) {
    const auto [from, to] = endsOf(side);
    for (const std::int32_t index : faces_of_[static_cast<std::size_t>(side.piece)]) {
      mesh::Face& face = solid_.faces[static_cast<std::size_t>(index)];
      for (std::size_t k = 0; k < 3; ++k) {
        if (face[k] != from || face[(k + 1) % 3] != to) continue;
        const std::int32_t opposite = face[(k + 2) % 3];
        face = {from, middle, opposite};
        add({middle, to, opposite}, side.piece);
        return;
      }
    }
  }
  Solid solid_;
  std::vector<mesh::Face> whole_;                    // of each piece, before any edge was halved
  std::vector<std::vector<std::int32_t>> faces_of_;  // of each piece
};

}  // namespace

Solid solidOf(const std::vector<Piece>& pieces, const Points& points) {
  Corners corners(pieces.size());
  std::vector<Pair> crowded;
  eachEdge(sidesOf(pieces), [&](const PieceSide* first, const PieceSide* last) {
    if (last - first == 2) {
      corners.join(first[0], first[1]);
    } else {
      addPairs(first, last, pieces, points, crowded);
    }
  });
  for (const Pair& pair : crowded) corners.join(pair.one, pair.other);
  Building building(pieces, corners);
  for (std::size_t k = 0; k < crowded.size(); ++k) {
    const Pair& pair = crowded[k];
    bool is_alike = false;  // to one of the same edge, which are in a row
    for (std::size_t other = k; other-- > 0 && !is_alike;) {
      const Pair& before = crowded[other];
      if (before.one.low != pair.one.low || before.one.high != pair.one.high) break;
      is_alike = building.endsOf(before.one) == building.endsOf(pair.one);
    }
    if (is_alike) building.halve(pair);
  }
  return building.take();
}

}  // namespace underact::mesh_union
