#include "core/mesh/search.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/mesh/around_part.h"
#include "core/mesh/box_bounds.h"
#include "core/mesh/face_bounds.h"
#include "core/mesh/normals.h"
#include "core/mesh/tree.h"

namespace underact::mesh {
namespace {

/// The greatest number of steps of a walk. A hand moves some tenths of a millimetre in a tick: one or two faces of a
/// fine mesh.
constexpr int kMaxSteps = 256;
/// Steps of a walk that the tree follows anyway: a farther point is found faster from the root.
constexpr int kHybridSteps = 12;
/// A point further away than this many times the size of the surface is moved nearer, so that floats hold the squares.
constexpr double kFar = 1e6;

/// Whether the face is nearer than the best so far.
bool visitFace(const Surface& surface, std::int32_t face, const Vec3& q_M, Hit& hit) noexcept UNDERACT_REAL_TIME {
  const Face& corners = surface.triangles.faces[static_cast<std::size_t>(face)];
  const auto at = [&](std::size_t k) noexcept UNDERACT_REAL_TIME -> const Eigen::Vector3f& {
    return surface.triangles.p_MV[static_cast<std::size_t>(corners[k])];
  };
  const OnTriangle found = onTriangle(at(0), at(1), at(2), q_M);
  if (!(found.squared < hit.squared)) return false;
  hit.p_M = found.p_M;
  hit.squared = found.squared;
  hit.face = face;
  hit.part = found.part;
  return true;
}

/// The last few faces of a walk: no search looks at them twice.
class Recent {
 public:
  void add(std::int32_t face) noexcept UNDERACT_REAL_TIME { faces_[count_++ % faces_.size()] = face; }
  bool has(std::int32_t face) const noexcept UNDERACT_REAL_TIME {
    bool is_in = false;
    for (const std::int32_t one : faces_) is_in |= one == face;
    return is_in;
  }

 private:
  std::array<std::int32_t, 4> faces_{-1, -1, -1, -1};  // along a hand's path a walk looks at three
  std::size_t count_ = 0;
};

/// Walks from face to face, across edges and around corners, while the distance decreases. Gives whether it reached a
/// minimum.
bool walk(const Surface& surface, const Vec3& q_M, int max_steps, Recent& recent,
          Hit& hit) noexcept UNDERACT_REAL_TIME {
  for (int step = 0; step < max_steps; ++step) {
    const std::int32_t face = hit.face;
    if (face < 0) return false;
    forNeighbours(surface, face, hit.part, [&](std::int32_t other) noexcept UNDERACT_REAL_TIME {
      recent.add(other);
      return !visitFace(surface, other, q_M, hit);
    });
    if (hit.face == face) return true;
  }
  return false;
}

/// The capacity of a sweep, nodes or faces: along a hand's path some twenty are enough.
constexpr std::size_t kRoom = 256;
using List = std::array<std::int32_t, kRoom + kChildren>;
/// How many nodes ahead memory is prefetched; without it, a path over a fine mesh takes 6 % longer.
constexpr std::size_t kAhead = 3;

/// Looks at faces, four at a time; exactly only where a face may be nearer than the best so far.
void visitFaces(const Surface& surface, const List& faces, std::size_t count, const Recent& recent, const Vec3& q_M,
                Hit& hit) noexcept UNDERACT_REAL_TIME {
  std::array<std::int32_t, kAtOnce> four{};
  std::size_t size = 0;
  const auto lookAtFour = [&]() noexcept UNDERACT_REAL_TIME {
    for (std::size_t k = size; k < kAtOnce; ++k) four[k] = four[0];
    const std::array<float, kAtOnce> bounds = faceBounds(surface, four, q_M);
    for (std::size_t k = 0; k < size; ++k) {
      if (static_cast<double>(bounds[k]) < hit.squared) visitFace(surface, four[k], q_M, hit);
    }
    size = 0;
  };
  for (std::size_t place = 0; place < count; ++place) {
    four[size] = -1 - faces[place];
    size += recent.has(four[size]) ? 0 : 1;
    if (size == kAtOnce) lookAtFour();
  }
  if (size > 0) lookAtFour();
}

/// Prefetches a node.
void fetch(const Node& node) noexcept UNDERACT_REAL_TIME {
  constexpr std::size_t kCacheLine = 64;
  for (std::size_t byte = 0; byte < sizeof(Node); byte += kCacheLine)
    __builtin_prefetch(reinterpret_cast<const char*>(&node) + byte);
}

/// From the cut, level by level, with the best so far as the limit. The nodes of a level are independent of each other,
/// so that the processor handles many at a time, which is faster than nearest first where the limit is good. False:
/// there is too much within the limit, and no result.
bool sweep(const Surface& surface, const Recent& recent, const Vec3& q_M, Cut& cut,
           Hit& hit) noexcept UNDERACT_REAL_TIME {
  const double distance = std::sqrt(hit.squared);
  if (!holds(cut, surface, q_M, distance)) cut = nextCut(cut, surface, q_M, distance, hit.visits);
  ++cut.served;
  List nodes, faces;  // not initialised
  std::copy(cut.nodes.begin(), cut.nodes.end(), nodes.begin());
  std::size_t waiting = cut.size, found = 0, place = 0;
  const auto nodeAt = [&](std::size_t at) noexcept UNDERACT_REAL_TIME -> const Node& {
    return surface.nodes[static_cast<std::size_t>(nodes[at])];
  };
  for (; place < waiting; ++place) {
    if (waiting > kRoom || found > kRoom) break;
    const Node& node = nodeAt(place);
    fetch(nodeAt(std::min(place + kAhead, waiting - 1)));
    const unsigned nearer = boundsOf(node, q_M, hit.squared).nearer;
    if (node.children[0] < 0) {
      found += addChildren(node, nearer, &faces[found]);
    } else {
      waiting += addChildren(node, nearer, &nodes[waiting]);
    }
  }
  hit.visits += static_cast<int>(place);
  if (place < waiting) return false;
  visitFaces(surface, faces, found, recent, q_M, hit);
  hit.is_proved = true;
  return true;
}

/// A node still to be looked at; the nearest is last.
struct Waiting {
  float squared;  // of the distance, at least
  std::int32_t child;
};
using Stack = std::array<Waiting, (kChildren - 1) * kMaxDepth + kChildren>;

/// From the root, the nearest box first: where there is no limit yet, or too much within it.
void searchBestFirst(const Surface& surface, const Vec3& q_M, Hit& hit) noexcept UNDERACT_REAL_TIME {
  Stack stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0.0F, 0};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (!(static_cast<double>(next.squared) < hit.squared)) continue;
    if (next.child < 0) {
      visitFace(surface, -1 - next.child, q_M, hit);
      continue;
    }
    if (hit.visits >= kMaxVisits) return;
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

/// Whether q is so far from the last search that its result is of no use: a walk from there would cost more than it
/// saves. A hand moves a few millimetres in a tick, so this happens only with meshes that are hardly larger.
bool isLeap(const Surface& surface, const Cut& cut, const Vec3& q_M) noexcept UNDERACT_REAL_TIME {
  constexpr float kOfExtent = 1.0F / 12.0F;
  const Eigen::Vector3f extent = surface.high_M - surface.low_M;
  const double far =
      cut.reach + static_cast<double>(kOfExtent * std::max(extent.x(), std::max(extent.y(), extent.z())));
  return cut.reach > 0.0 && (q_M - cut.q_M).squaredNorm() > far * far;
}

}  // namespace

Hit nearestPoint(const Surface& surface, Search search, const Vec3& q_M, SearchState& state) noexcept {
  const Vec3 low = surface.low_M.cast<double>(), high = surface.high_M.cast<double>();
  const Vec3 far = Vec3::Constant(kFar * std::max((high - low).norm(), 1e-30));
  const Vec3 min = low - far, max = high + far;
  const Vec3 at(std::clamp(q_M.x(), min.x(), max.x()), std::clamp(q_M.y(), min.y(), max.y()),
                std::clamp(q_M.z(), min.z(), max.z()));
  const bool knows = state.face >= 0 && state.face < static_cast<std::int32_t>(surface.triangles.faces.size());
  Hit hit;
  bool is_near = false;
  Recent recent;
  const bool leaps = search == Search::Hybrid && isLeap(surface, state.cut, at);
  if (knows && search != Search::Global && !leaps) {
    recent.add(state.face);
    visitFace(surface, state.face, at, hit);
    is_near = walk(surface, at, search == Search::Local ? kMaxSteps : kHybridSteps, recent, hit);
  }
  const bool is_done = search == Search::Local ? hit.face >= 0 : is_near && sweep(surface, recent, at, state.cut, hit);
  if (!is_done) searchBestFirst(surface, at, hit);
  // A cut without surface: it only says where the search was.
  if (search == Search::Hybrid && (leaps || !(state.cut.reach > 0.0)))
    state.cut = {at, std::sqrt(hit.squared), 0, 0, 1, {}};
  if (at != q_M) {
    hit.squared = (q_M - hit.p_M).squaredNorm();
    hit.is_proved = false;
  }
  state.face = hit.face;
  return hit;
}

Vec3 outwardAt(const Surface& surface, const Hit& hit) noexcept {
  if (hit.face < 0) return Vec3::Zero();
  const auto face = static_cast<std::size_t>(hit.face);
  const auto part = static_cast<std::size_t>(hit.part);
  if (hit.part == Part::Inside) return normalOf(surface, hit.face);
  if (hit.part >= Part::CornerA) {
    const std::size_t corner = part - static_cast<std::size_t>(Part::CornerA);
    return surface.normals_M[static_cast<std::size_t>(surface.triangles.faces[face][corner])].cast<double>();
  }
  const std::int32_t neighbour = surface.neighbours[face][part - static_cast<std::size_t>(Part::EdgeAB)];
  Vec3 sum = normalOf(surface, hit.face);
  if (neighbour >= 0) sum += normalOf(surface, neighbour);
  const double length = sum.norm();
  return length > 0.0 ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

}  // namespace underact::mesh
