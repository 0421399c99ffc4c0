#include "core/mesh_union/contact.h"

#include <algorithm>

namespace underact::mesh_union {
namespace {

const GridPoint& cornerOf(const Grid& grid, const Flat& face, std::size_t k) {
  return grid.points[static_cast<std::size_t>(face.corners[k % 3])];
}

bool hasCorner(const Flat& face, std::int32_t corner) {
  return std::find(face.corners.begin(), face.corners.end(), corner) != face.corners.end();
}

/// A point of the face's plane in the face or on its border.
bool isOn(const Grid& grid, const Flat& face, const GridPoint& p) {
  const std::size_t axis = axisOf(face.plane);
  bool left = false, right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int turn = turnOf(axis, cornerOf(grid, face, k), cornerOf(grid, face, k + 1), p);
    left = left || turn > 0;
    right = right || turn < 0;
  }
  return !(left && right);
}

/// The edge from p to q, which goes through the face's plane, does so in the face or on its border.
bool goesThrough(const Grid& grid, const Flat& face, const GridPoint& p, const GridPoint& q) {
  bool left = false, right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = orientation(p, q, cornerOf(grid, face, k), cornerOf(grid, face, k + 1));
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

using Signs = std::array<int, 3>;

Signs sidesOf(const Grid& grid, const Flat& face, const Plane& plane) {
  Signs signs{};
  for (std::size_t k = 0; k < 3; ++k) signs[k] = signOf(heightOf(plane, cornerOf(grid, face, k)));
  return signs;
}

bool areAll(const Signs& signs, int sign) {
  return signs[0] == sign && signs[1] == sign && signs[2] == sign;
}

/// Where a face comes through or to another one.
class Meeting {
 public:
  Meeting(const Grid& grid, Points& points) : grid_(grid), points_(points) {}
  void poll(const Flat& face, const Signs& signs, const Flat& at) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t p = face.corners[k], q = face.corners[(k + 1) % 3];
      if (signs[k] == 0 && !hasCorner(at, p)) {
        if (isOn(grid_, at, cornerOf(grid_, face, k))) add(p);
      } else if (signs[k] == 0) {
        shared_[shared_count_++ % 6] = p;
      }
      if (signs[k] * signs[(k + 1) % 3] < 0 &&
          goesThrough(grid_, at, cornerOf(grid_, face, k), cornerOf(grid_, face, k + 1))) {
        add(points_.onEdge(p, q, at.plane));
      }
    }
  }
  /// A corner that they share is an end where there is another point.
  std::array<std::int32_t, 2> ends() {
    if (count_ == 0) return {-1, -1};
    for (std::size_t k = 0; k < shared_count_ && count_ < 2; ++k) add(shared_[k]);
    return ends_;
  }

 private:
  void add(std::int32_t point) {
    if (count_ == 2 || (count_ == 1 && ends_[0] == point)) return;
    ends_[count_++] = point;
  }
  const Grid& grid_;
  Points& points_;
  std::array<std::int32_t, 2> ends_{-1, -1};
  std::size_t count_ = 0;
  std::array<std::int32_t, 6> shared_{};
  std::size_t shared_count_ = 0;
};

/// Whether an edge of one has all of the other on its far side.
bool isParted(const Grid& grid, const Flat& one, const Flat& other) {
  const std::size_t axis = axisOf(one.plane);
  const int around = one.plane.n[axis] > 0 ? 1 : -1;
  for (std::size_t k = 0; k < 3; ++k) {
    bool is_beyond = true;
    for (std::size_t j = 0; j < 3 && is_beyond; ++j) {
      const int turn = turnOf(axis, cornerOf(grid, one, k), cornerOf(grid, one, k + 1), cornerOf(grid, other, j));
      is_beyond = turn * around <= 0;
    }
    if (is_beyond) return true;
  }
  return false;
}

}  // namespace

Contact contactOf(const Grid& grid, const Flat& one, const Flat& other, Points& points) {
  Contact contact;
  const Signs of_other = sidesOf(grid, other, one.plane);
  if (areAll(of_other, 1) || areAll(of_other, -1)) return contact;
  if (areAll(of_other, 0)) {
    contact.overlap = !isParted(grid, one, other) && !isParted(grid, other, one);
    if (contact.overlap) return contact;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!hasCorner(one, other.corners[k]) && isOn(grid, one, cornerOf(grid, other, k)))
        contact.touched.push_back(other.corners[k]);
      if (!hasCorner(other, one.corners[k]) && isOn(grid, other, cornerOf(grid, one, k)))
        contact.touched.push_back(one.corners[k]);
    }
    return contact;
  }
  const Signs of_one = sidesOf(grid, one, other.plane);
  if (areAll(of_one, 1) || areAll(of_one, -1)) return contact;
  Meeting meeting(grid, points);
  meeting.poll(other, of_other, one);
  meeting.poll(one, of_one, other);
  contact.ends = meeting.ends();
  return contact;
}

}  // namespace underact::mesh_union
