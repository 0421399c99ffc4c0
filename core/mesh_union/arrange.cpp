#include "core/mesh_union/arrange.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/mesh_union/cells.h"
#include "core/mesh_union/contact.h"

namespace underact::mesh_union {
namespace {

constexpr std::int64_t kBetweenLooks = 1024;  // for cancellation

/// What another face cuts of one: a segment, or a point where both ends are the same.
struct Cut {
  std::int32_t plane_of, from, to, by;  // by: the face; -1: an edge of a face in the same plane
};

class Arranging {
 public:
  Arranging(const Grid& grid, const std::vector<mesh::Face>& faces, Points& points, const TaskMonitor& monitor,
            const Limits& limits)
      : grid_(grid), points_(points), monitor_(monitor), limits_(limits), flats_(faces.size()) {
    found_.plane_of.resize(faces.size());
    std::iota(found_.plane_of.begin(), found_.plane_of.end(), 0);
    for (std::size_t face = 0; face < faces.size(); ++face) {
      for (std::size_t k = 0; k < 3; ++k) flats_[face].corners[k] = points.ofCorner(faces[face][k]);
      const auto at = [&](std::size_t k) { return grid.points[static_cast<std::size_t>(flats_[face].corners[k])]; };
      flats_[face].plane = planeOf(at(0), at(1), at(2));
      if (!flats_[face].plane.isThere()) found_.plane_of[face] = -1;
    }
  }

  Arrangement all(const Boxes& boxes) {
    found_.is_whole = meetAll(boxes);
    if (!found_.is_whole) return std::move(found_);
    for (std::size_t face = 0; face < flats_.size(); ++face) {
      if (found_.plane_of[face] >= 0) found_.plane_of[face] = lead(static_cast<std::int32_t>(face));
    }
    for (Cut& cut : cuts_) cut.plane_of = found_.plane_of[static_cast<std::size_t>(cut.plane_of)];
    std::stable_sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
      return std::tie(a.plane_of, a.from, a.to) < std::tie(b.plane_of, b.from, b.to);
    });
    found_.is_whole = cutAll();
    return std::move(found_);
  }

 private:
  std::int32_t lead(std::int32_t face) {
    std::vector<std::int32_t>& of = found_.plane_of;
    while (of[static_cast<std::size_t>(face)] != face) {
      std::int32_t& next = of[static_cast<std::size_t>(face)];
      next = of[static_cast<std::size_t>(next)];
      face = next;
    }
    return face;
  }

  bool meetAll(const Boxes& boxes) {
    std::int64_t pairs = 0;
    bool is_ok = true;
    boxes.eachPair([&](std::int32_t a, std::int32_t b) {
      const Flat &one = flats_[static_cast<std::size_t>(a)], &other = flats_[static_cast<std::size_t>(b)];
      if (!one.plane.isThere() || !other.plane.isThere()) return true;
      is_ok = ++pairs <= limits_.pairs && found_.crossings <= limits_.crossings &&
              (pairs % kBetweenLooks != 0 || !monitor_.isCancelled());
      if (is_ok) meet(a, b);
      return is_ok;
    });
    return is_ok;
  }

  void meet(std::int32_t a, std::int32_t b) {
    const Contact contact =
        contactOf(grid_, flats_[static_cast<std::size_t>(a)], flats_[static_cast<std::size_t>(b)], points_);
    if (contact.overlap) {
      const std::int32_t first = lead(a), second = lead(b);
      found_.plane_of[static_cast<std::size_t>(std::max(first, second))] = std::min(first, second);
    }
    const std::int32_t from = contact.ends[0], to = contact.ends[1] < 0 ? from : contact.ends[1];
    if (from >= 0) {
      cuts_.push_back({a, from, to, b});
      cuts_.push_back({b, from, to, a});
    }
    for (const std::int32_t corner : contact.touched) {
      cuts_.push_back({a, corner, corner, b});
      cuts_.push_back({b, corner, corner, a});
    }
    found_.crossings += contact.overlap || from >= 0 || !contact.touched.empty() ? 1 : 0;
  }

  bool cutAll() {
    std::vector<std::vector<std::int32_t>> members(flats_.size());
    for (std::size_t face = 0; face < flats_.size(); ++face) {
      if (found_.plane_of[face] >= 0)
        members[static_cast<std::size_t>(found_.plane_of[face])].push_back(static_cast<std::int32_t>(face));
    }
    auto cut = cuts_.begin();
    for (std::size_t face = 0; face < flats_.size(); ++face) {
      if (members[face].empty()) continue;
      const auto first = cut;
      while (cut != cuts_.end() && cut->plane_of == static_cast<std::int32_t>(face)) ++cut;
      if (first == cut && members[face].size() == 1) {
        found_.pieces.push_back({flats_[face].corners, 1, static_cast<std::int32_t>(face), false});
        continue;
      }
      if (monitor_.isCancelled() || !cutOne(members[face], {first, cut})) return false;
    }
    return true;
  }

  bool cutOne(const std::vector<std::int32_t>& members, const std::vector<Cut>& cuts) {
    const Flat& first = flats_[static_cast<std::size_t>(members[0])];
    const std::size_t axis = axisOf(first.plane);
    Cells cells(points_, first.plane, members.size() == 1 ? ordered(first, axis) : around(axis));
    for (const std::int32_t member : members) {
      for (const std::int32_t corner : flats_[static_cast<std::size_t>(member)].corners) cells.add(corner);
    }
    // A corner of another face may touch an overlapping neighbour in the plane without being on any face here.
    for (const Cut& cut : cuts) {
      cells.add(cut.from);
      cells.add(cut.to);
    }
    if (members.size() > 1) {
      for (const std::int32_t member : members) constrainEdges(flats_[static_cast<std::size_t>(member)], axis, cells);
    }
    for (const Cut& cut : cuts) {
      if (cut.from != cut.to) cells.constrain(cut.from, cut.to, flats_[static_cast<std::size_t>(cut.by)].plane);
    }
    cells.improve();
    if (cells.hasFailed()) return false;
    const bool is_cut = cells.all().size() > 1;
    for (const Cells::Cell& cell : cells.all()) addPiece(cell, members, axis, is_cut);
    return true;
  }

  static std::array<std::int32_t, 3> ordered(const Flat& face, std::size_t axis) {
    const auto [a, b, c] = face.corners;
    if (face.plane.n[axis] > 0) return {a, b, c};
    return {a, c, b};
  }

  /// Of points that are on no face, around them all as seen along the axis.
  std::array<std::int32_t, 3> around(std::size_t axis) {
    constexpr std::int64_t kBeyond = std::int64_t{1} << 25U;
    const auto at = [&](std::int64_t u, std::int64_t v) {
      GridPoint p{};
      p[(axis + 1) % 3] = u * kBeyond;
      p[(axis + 2) % 3] = v * kBeyond;
      return points_.beside(p);
    };
    return {at(-4, -2), at(4, -2), at(0, 4)};
  }

  void constrainEdges(const Flat& face, std::size_t axis, Cells& cells) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = face.corners[k], b = face.corners[(k + 1) % 3];
      cells.constrain(
          a, b, planeAlong(grid_.points[static_cast<std::size_t>(a)], grid_.points[static_cast<std::size_t>(b)], axis));
    }
  }

  bool isIn(const Cells::Cell& cell, const Flat& face, std::size_t axis) const {
    const int around = face.plane.n[axis] > 0 ? 1 : -1;
    for (const std::int32_t corner : cell.corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (points_.turn(axis, face.corners[k], face.corners[(k + 1) % 3], corner) * around < 0) return false;
      }
    }
    return true;
  }

  void addPiece(const Cells::Cell& cell, const std::vector<std::int32_t>& members, std::size_t axis, bool is_cut) {
    Piece piece{cell.corners, 0, members[0], is_cut};
    for (const std::int32_t member : members) {
      const Flat& face = flats_[static_cast<std::size_t>(member)];
      if (members.size() > 1 && !isIn(cell, face, axis)) continue;
      piece.times += face.plane.n[axis] > 0 ? 1 : -1;
    }
    if (piece.times == 0) return;
    if (piece.times < 0) {
      piece.times = -piece.times;
      std::swap(piece.corners[1], piece.corners[2]);
    }
    found_.pieces.push_back(piece);
  }

  const Grid& grid_;
  Points& points_;
  const TaskMonitor& monitor_;
  const Limits& limits_;
  std::vector<Flat> flats_;
  std::vector<Cut> cuts_;
  Arrangement found_;
};

}  // namespace

Arrangement arrange(const Grid& grid, const std::vector<mesh::Face>& faces, const Boxes& boxes, Points& points,
                    const TaskMonitor& monitor, const Limits& limits) {
  return Arranging(grid, faces, points, monitor, limits).all(boxes);
}

}  // namespace underact::mesh_union
