#include "core/mesh_union/tidy.h"

#include <algorithm>
#include <deque>

namespace underact::mesh_union {
namespace {

using mesh::Face;

bool has(const Face& face, std::int32_t corner) {
  return face[0] == corner || face[1] == corner || face[2] == corner;
}

std::size_t placeIn(const Face& face, std::int32_t corner) {
  return face[0] == corner ? 0 : face[1] == corner ? 1 : 2;
}

class Tidying {
 public:
  Tidying(mesh::Triangles& triangles, Made made, double min)
      : triangles_(triangles), made_(std::move(made)), min_(min) {
    around_.resize(triangles.p_MV.size());
    for (std::size_t face = 0; face < triangles.faces.size(); ++face) {
      for (const std::int32_t corner : triangles.faces[face]) at(corner).push_back(static_cast<std::int32_t>(face));
      if (made_.faces[face] != 0) waiting_.push_back(static_cast<std::int32_t>(face));
    }
    is_gone_.assign(triangles.faces.size(), 0);
  }

  void all() {
    const std::size_t max = 20 * waiting_.size() + 100;
    for (std::size_t step = 0; step < max && !waiting_.empty(); ++step) {
      const std::int32_t face = waiting_.front();
      waiting_.pop_front();
      if (is_gone_[static_cast<std::size_t>(face)] == 0) poll(face);
    }
    std::size_t kept = 0;
    for (std::size_t face = 0; face < triangles_.faces.size(); ++face) {
      if (is_gone_[face] == 0) triangles_.faces[kept++] = triangles_.faces[face];
    }
    triangles_.faces.resize(kept);
  }

 private:
  std::vector<std::int32_t>& at(std::int32_t corner) { return around_[static_cast<std::size_t>(corner)]; }
  Face& faceAt(std::int32_t face) { return triangles_.faces[static_cast<std::size_t>(face)]; }
  Vec3 p(std::int32_t corner) const { return cornerAt(triangles_, corner); }
  Vec3 areaOf(const Face& face) const { return (p(face[1]) - p(face[0])).cross(p(face[2]) - p(face[0])); }

  double heightOf(const Face& face) const {
    const double longest = std::max(
        {(p(face[1]) - p(face[0])).norm(), (p(face[2]) - p(face[1])).norm(), (p(face[0]) - p(face[2])).norm()});
    return longest > 0.0 ? areaOf(face).norm() / longest : 0.0;
  }

  void poll(std::int32_t index) {
    const Face face = faceAt(index);
    std::array<double, 3> length{};
    for (std::size_t k = 0; k < 3; ++k) length[k] = (p(face[(k + 1) % 3]) - p(face[k])).norm();
    const auto shortest = static_cast<std::size_t>(std::min_element(length.begin(), length.end()) - length.begin());
    const auto longest = static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
    if (length[shortest] < min_) {
      const std::int32_t a = face[shortest], b = face[(shortest + 1) % 3];
      if (collapse(a, b) || collapse(b, a)) return;
    }
    if (heightOf(face) < min_) {
      flip(index, longest, Why::Low);
      return;
    }
    for (std::size_t side = 0; side < 3; ++side) {
      if (isFolded(index, side)) {
        flip(index, side, Why::Folded);
        return;
      }
    }
  }

  /// The other face at a side; -1: there is none.
  std::int32_t across(std::int32_t index, std::size_t side) {
    const Face& face = faceAt(index);
    for (const std::int32_t one : at(face[side])) {
      if (one != index && has(faceAt(one), face[(side + 1) % 3])) return one;
    }
    return -1;
  }

  /// The face lies on the one across the side, back to back or front to front, and nowhere is more between them: a gap
  /// or a blade that is narrower than floats can tell. Only one of the two sees it, the one with less behind the side.
  bool isFolded(std::int32_t index, std::size_t side) {
    const std::int32_t other = across(index, side);
    if (other < 0) return false;
    const Face &face = faceAt(index), &beside = faceAt(other);
    const Vec3 own = areaOf(face), its = areaOf(beside);
    if (!(own.dot(its) < 0.0) || own.norm() > its.norm()) return false;
    const double between = std::abs(its.dot(p(face[(side + 2) % 3]) - p(face[side])));
    return between < min_ * its.norm();
  }

  /// Of the corners that share a face with it, in order.
  std::vector<std::int32_t> beside(std::int32_t corner) {
    std::vector<std::int32_t> others;
    for (const std::int32_t face : at(corner)) {
      for (const std::int32_t other : faceAt(face)) {
        if (other != corner) others.push_back(other);
      }
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    return others;
  }

  /// The face with a new corner in place of an old one does not turn over, as far as it is wide enough to say.
  bool staysUp(const Face& old, const Face& now) const {
    return heightOf(old) < min_ || heightOf(now) < min_ || areaOf(old).dot(areaOf(now)) > 0.0;
  }

  /// Draws a corner that was made to another one.
  bool collapse(std::int32_t from, std::int32_t to) {
    if (made_.corners[static_cast<std::size_t>(from)] == 0) return false;
    const std::vector<std::int32_t> of_from = beside(from), of_to = beside(to);
    std::vector<std::int32_t> both;
    std::set_intersection(of_from.begin(), of_from.end(), of_to.begin(), of_to.end(), std::back_inserter(both));
    if (both.size() != 2 || of_from.size() < 3 || (of_from.size() == 3 && of_to.size() == 3)) return false;
    for (const std::int32_t face : at(from)) {
      Face now = faceAt(face);
      if (has(now, to)) continue;
      now[placeIn(now, from)] = to;
      if (!staysUp(faceAt(face), now)) return false;
    }
    const std::vector<std::int32_t> faces = at(from);
    for (const std::int32_t face : faces) {
      if (has(faceAt(face), to)) {
        is_gone_[static_cast<std::size_t>(face)] = 1;
        for (const std::int32_t corner : faceAt(face)) std::erase(at(corner), face);
        continue;
      }
      faceAt(face)[placeIn(faceAt(face), from)] = to;
      at(to).push_back(face);
    }
    at(from).clear();
    for (const std::int32_t face : at(to)) again(face);
    return true;
  }

  enum class Why { Low, Folded };

  void flip(std::int32_t index, std::size_t side, Why why) {
    const Face face = faceAt(index);
    const std::int32_t a = face[side], b = face[(side + 1) % 3], c = face[(side + 2) % 3];
    const std::int32_t other = across(index, side);
    if (other < 0) return;
    const Face beyond = faceAt(other);
    const std::int32_t d = beyond[(placeIn(beyond, b) + 2) % 3];
    const std::vector<std::int32_t> of_c = beside(c);
    if (d == c || std::binary_search(of_c.begin(), of_c.end(), d)) return;
    const Face one{a, d, c}, two{d, b, c};
    if (!staysUp(beyond, one) || !staysUp(beyond, two)) return;
    const bool is_better = std::min(heightOf(one), heightOf(two)) >= std::min(heightOf(face), heightOf(beyond));
    if (why == Why::Low && !is_better) return;
    faceAt(index) = one;
    faceAt(other) = two;
    made_.faces[static_cast<std::size_t>(other)] = 1;
    std::erase(at(a), other);
    std::erase(at(b), index);
    at(d).push_back(index);
    at(c).push_back(other);
    again(index);
    again(other);
    for (std::size_t k = 0; k < 3; ++k) {  // which may be folded on what is beside them now
      for (const std::int32_t changed : {index, other}) {
        if (const std::int32_t next = across(changed, k); next >= 0) again(next);
      }
    }
  }

  void again(std::int32_t face) {
    if (made_.faces[static_cast<std::size_t>(face)] != 0) waiting_.push_back(face);
  }

  mesh::Triangles& triangles_;
  Made made_;
  double min_;
  std::vector<std::vector<std::int32_t>> around_;  // of each corner: its faces
  std::vector<std::uint8_t> is_gone_;
  std::deque<std::int32_t> waiting_;
};

}  // namespace

void tidy(mesh::Triangles& triangles, const Made& made, double min) {
  Tidying(triangles, made, min).all();
}

}  // namespace underact::mesh_union
