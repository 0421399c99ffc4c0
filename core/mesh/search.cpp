#include "core/mesh/search.h"

#include <algorithm>
#include <bit>

#include "core/mesh/around_part.h"
#include "core/mesh/box_bounds.h"
#include "core/mesh/normals.h"
#include "core/mesh/tree.h"

namespace underact::mesh {
namespace {

/// A walk's steps from face to face. A hand goes some tenths of a millimetre in a tick: one or two faces of a fine
/// mesh.
constexpr int kMostSteps = 256;
/// Of a walk that the tree follows anyway: who is farther off is found from the root sooner.
constexpr int kHybridSteps = 12;
/// Further off than this many times its size a surface is looked at from nearer: floats hold the squares.
constexpr double kFar = 1e6;

/// Whether it is nearer than what was found so far.
bool lookAtFace(const Surface& surface, std::int32_t face, const Vec3& q_M, Hit& hit) noexcept UNDERACT_REAL_TIME {
  const auto [a, b, c] = cornersOf(surface, face);

  const OnTriangle found = onTriangle(a, b, c, q_M);
  if (!(found.squared < hit.squared)) return false;
  hit.p_M = found.p_M;
  hit.squared = found.squared;
  hit.face = face;
  hit.part = found.part;
  return true;
}

/// From face to face, across edges and around corners, while it gets nearer. Whether it came to the end of that.
bool walk(const Surface& surface, const Vec3& q_M, int most_steps, Hit& hit) noexcept UNDERACT_REAL_TIME {
  for (int step = 0; step < most_steps; ++step) {
    const std::int32_t face = hit.face;
    if (face < 0) return false;
    forNeighbours(surface, face, hit.part, [&](std::int32_t other) noexcept UNDERACT_REAL_TIME {
      return !lookAtFace(surface, other, q_M, hit);
    });
    if (hit.face == face) return true;
  }
  return false;
}

/// Nodes or faces in a row.
class List {
 public:
  /// Those children of the node that bounds leave; without a branch a child, since nobody can tell beforehand which.
  void add(const Node& node, const BoxBounds& bounds) noexcept UNDERACT_REAL_TIME {
    std::size_t size = size_;
#pragma GCC unroll 8
    for (std::size_t child = 0; child < kWays; ++child) {
      entries_[size] = {bounds.squared[child], node.children[child]};
      size += bounds.nearer >> child & 1U;
    }
    size_ = size;
  }
  void add(std::int32_t child) noexcept UNDERACT_REAL_TIME {
    entries_[size_++] = {0.0F, child};
  }
  void clear() noexcept UNDERACT_REAL_TIME {
    size_ = 0;
  }
  bool hasRoom() const noexcept UNDERACT_REAL_TIME {
    return size_ <= kRoom;
  }
  struct Entry {
    float squared;  // of the distance, at least
    std::int32_t child;
  };
  const Entry* begin() const noexcept UNDERACT_REAL_TIME {
    return entries_.data();
  }
  const Entry* end() const noexcept UNDERACT_REAL_TIME {
    return entries_.data() + size_;
  }

 private:
  static constexpr std::size_t kRoom = 128;  // along a hand's way some twenty are enough
  std::size_t size_ = 0;
  std::array<Entry, kRoom + 2 * kWays> entries_;  // not set beforehand
};

/// Level by level, with what was found so far as the limit. No node waits for what another one gives, so that the
/// processor does many at a time, which is faster than the nearest first where the limit is good. False: there is
/// too much within the limit; then nothing is said.
bool sweep(const Surface& surface, const Vec3& q_M, Hit& hit) noexcept UNDERACT_REAL_TIME {
  std::array<List, 2> levels;
  List faces;
  levels[0].add(0);
  for (std::size_t level = 0; levels[level % 2].begin() != levels[level % 2].end(); ++level) {
    List& below = levels[(level + 1) % 2];
    below.clear();
    for (const List::Entry& entry : levels[level % 2]) {
      const Node& node = surface.nodes[static_cast<std::size_t>(entry.child)];
      (node.children[0] < 0 ? faces : below).add(node, boundsOf(node, q_M, hit.squared));
      ++hit.visits;
      if (!faces.hasRoom() || !below.hasRoom()) return false;
    }
  }
  for (const List::Entry& entry : faces) {
    if (static_cast<double>(entry.squared) < hit.squared) lookAtFace(surface, -1 - entry.child, q_M, hit);
  }
  hit.is_proved = true;
  return true;
}

/// What is still to be looked at, the nearest last.
using Stack = std::array<List::Entry, (kWays - 1) * kMostDepth + kWays>;

/// Asks for the memory of a node before it is looked at.
void fetch(const Node& node) noexcept UNDERACT_REAL_TIME {
  constexpr std::size_t kCacheLine = 64;
  for (std::size_t byte = 0; byte < sizeof(Node); byte += kCacheLine)
    __builtin_prefetch(reinterpret_cast<const char*>(&node) + byte);
}

/// From the root, the nearest box first: where there is no limit yet, or too much within it.
void searchBestFirst(const Surface& surface, const Vec3& q_M, Hit& hit) noexcept UNDERACT_REAL_TIME {
  Stack stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0.0F, 0};
  while (waiting > 0) {
    const List::Entry next = stack[--waiting];
    if (!(static_cast<double>(next.squared) < hit.squared)) continue;
    if (next.child < 0) {
      lookAtFace(surface, -1 - next.child, q_M, hit);
      continue;
    }
    if (hit.visits >= kMostVisits) return;
    ++hit.visits;
    const Node& node = surface.nodes[static_cast<std::size_t>(next.child)];
    const BoxBounds bounds = boundsOf(node, q_M, hit.squared);
    const std::size_t bottom = waiting;
    for (unsigned left = bounds.nearer; left != 0; left &= left - 1) {
      const auto child = static_cast<std::size_t>(std::countr_zero(left));
      std::size_t place = waiting++;
      for (; place > bottom && stack[place - 1].squared < bounds.squared[child]; --place)
        stack[place] = stack[place - 1];
      stack[place] = {bounds.squared[child], node.children[child]};
      if (node.children[child] >= 0) fetch(surface.nodes[static_cast<std::size_t>(node.children[child])]);
    }
  }
  hit.is_proved = true;
}

}  // namespace

Hit nearestPoint(const Surface& surface, Search search, const Vec3& q_M, SearchState& state) noexcept {
  const Vec3 low = surface.low_M.cast<double>(), high = surface.high_M.cast<double>();
  const Vec3 far = Vec3::Constant(kFar * std::max((high - low).norm(), 1e-30));
  const Vec3 at = q_M.cwiseMax(low - far).cwiseMin(high + far);
  const bool knows = state.face >= 0 && state.face < static_cast<std::int32_t>(surface.triangles.faces.size());
  Hit hit;
  bool is_near = false;
  if (knows && search != Search::Global) {
    lookAtFace(surface, state.face, at, hit);
    is_near = walk(surface, at, search == Search::Local ? kMostSteps : kHybridSteps, hit);
  }
  const bool is_done = search == Search::Local ? hit.face >= 0 : is_near && sweep(surface, at, hit);
  if (!is_done) searchBestFirst(surface, at, hit);
  if (at != q_M) {
    hit.squared = (q_M - hit.p_M).squaredNorm();
    hit.is_proved = false;
  }
  state.face = hit.face;
  return hit;
}

Vec3 outwardAt(const Surface& surface, const Hit& hit) noexcept {
  if (hit.face < 0) return Vec3::Zero();
  const auto normalOf = [&](std::int32_t face) noexcept UNDERACT_REAL_TIME -> Vec3 {
    const auto [a, b, c] = cornersOf(surface, face);
    const Vec3 normal = areaNormal(a, b, c);
    const double length = normal.norm();
    return length > 0.0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
  };
  const auto face = static_cast<std::size_t>(hit.face);
  const auto part = static_cast<std::size_t>(hit.part);
  if (hit.part == Part::Inside) return normalOf(hit.face);
  if (hit.part >= Part::CornerA) {
    const std::size_t corner = part - static_cast<std::size_t>(Part::CornerA);
    return surface.normals_M[static_cast<std::size_t>(surface.triangles.faces[face][corner])].cast<double>();
  }
  const std::int32_t neighbour = surface.neighbours[face][part - static_cast<std::size_t>(Part::EdgeAB)];
  Vec3 sum = normalOf(hit.face);
  if (neighbour >= 0) sum += normalOf(neighbour);
  const double length = sum.norm();
  return length > 0.0 ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

}  // namespace underact::mesh
