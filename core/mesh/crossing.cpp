#include "core/mesh/crossing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/norms.h"
#include "core/mesh/search.h"
#include "core/mesh/tree.h"

namespace underact::mesh {
namespace {

/// The path, sheared so that it runs along its longest coordinate: then it passes through a face whose corners, seen
/// along that axis, surround 0. Corners shared by faces are sheared identically, to the bit.
class Sheared {
 public:
  Sheared(const Vec3& from_M, const Vec3& to_M) noexcept UNDERACT_REAL_TIME : from_M_(from_M) {
    const Vec3 span_M = to_M - from_M;
    for (Eigen::Index axis = 1; axis < 3; ++axis) {
      if (std::abs(span_M[axis]) > std::abs(span_M[along_])) along_ = axis;
    }
    length_ = span_M[along_];
    shear_ = {span_M[(along_ + 1) % 3] / length_, span_M[(along_ + 2) % 3] / length_};
  }
  /// The two coordinates across the path, and the share along it.
  Vec3 of(const Vec3& p_M) const noexcept UNDERACT_REAL_TIME {
    const Vec3 v_M = p_M - from_M_;
    const double along = v_M[along_];
    return {v_M[(along_ + 1) % 3] - shear_[0] * along, v_M[(along_ + 2) % 3] - shear_[1] * along, along / length_};
  }
  double length() const noexcept UNDERACT_REAL_TIME { return length_; }
  /// The share of the path within the rounding of the coordinates. A tip that rests on a face must not pass through it,
  /// and which side it is on is decided by other means.
  double slack(const Surface& surface) const noexcept UNDERACT_REAL_TIME {
    constexpr double kRounding = 1e-12;
    const double largest = std::max(largestOf(surface.low_M.cast<double>()), largestOf(surface.high_M.cast<double>()));
    return kRounding * (largest + largestOf(from_M_)) / std::abs(length_);
  }

 private:
  Vec3 from_M_;
  Eigen::Index along_ = 0;
  double length_ = 0.0;
  std::array<double, 2> shear_{};
};

/// The share of the path at which it passes through the face; infinite where it does not.
double shareAt(const Surface& surface, std::int32_t face, CrossingDirection direction, const Sheared& sheared,
               double slack) noexcept UNDERACT_REAL_TIME {
  const auto [a_M, b_M, c_M] = cornersOf(surface, face);
  const Vec3 a = sheared.of(a_M), b = sheared.of(b_M), c = sheared.of(c_M);
  const auto area = [](const Vec3& from, const Vec3& to) noexcept UNDERACT_REAL_TIME {
    return from.x() * to.y() - from.y() * to.x();
  };
  const double at_a = area(b, c), at_b = area(c, a), at_c = area(a, b);
  const double whole = at_a + at_b + at_c;
  // Counterclockwise as seen from the end of the axis: the normal points along it.
  const bool is_against = (whole < 0.0) == (sheared.length() > 0.0);
  if (whole == 0.0 || is_against != (direction == CrossingDirection::Inwards)) return kInfinity;
  const bool is_through =
      whole > 0.0 ? at_a >= 0.0 && at_b >= 0.0 && at_c >= 0.0 : at_a <= 0.0 && at_b <= 0.0 && at_c <= 0.0;
  if (!is_through) return kInfinity;
  const double share = (at_a * a.z() + at_b * b.z() + at_c * c.z()) / whole;
  return share >= -slack && share <= 1.0 + slack ? share : kInfinity;
}

/// The path in the frame of a node: its middle, and half of it.
struct PathInNode {
  std::array<double, 3> middle{}, half{}, low{}, high{};
  double wider = 0.0;  // for the rounding of floats, and of the tests
};
PathInNode pathIn(const Node& node, const Vec3& from_M, const Vec3& to_M) noexcept UNDERACT_REAL_TIME {
  constexpr double kWider = 1e-6;
  PathInNode path;
  double size = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double from = 0.0, to = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      const auto r = static_cast<double>(node.R_MN[3 * k + axis]), p = static_cast<double>(node.p_MN[k]);
      from += r * (from_M[column] - p);
      to += r * (to_M[column] - p);
    }
    path.low[axis] = std::min(from, to);
    path.high[axis] = std::max(from, to);
    path.middle[axis] = 0.5 * (from + to);
    path.half[axis] = 0.5 * (to - from);
    size = std::max({size, std::abs(from), std::abs(to)});
  }
  path.wider = kWider * size;
  return path;
}

/// Whether a box is beside the path: their shadows across the path and one of the box's axes are apart. Source: Ericson
/// 2005, Real-Time Collision Detection, section 5.3.3.
bool isBeside(const Node& node, std::size_t child, const PathInNode& path) noexcept UNDERACT_REAL_TIME {
  std::array<double, 3> to_box{}, reach{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto low = static_cast<double>(node.low_N[axis][child]), high = static_cast<double>(node.high_N[axis][child]);
    to_box[axis] = 0.5 * (low + high) - path.middle[axis];
    reach[axis] = 0.5 * (high - low) + path.wider;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
    if (std::abs(to_box[j] * path.half[k] - to_box[k] * path.half[j]) >
        reach[j] * std::abs(path.half[k]) + reach[k] * std::abs(path.half[j]))
      return true;
  }
  return false;
}

/// The boxes of the node that the path may meet, one bit each: those within its bounds, and of these, where it is long,
/// those that are not beside it.
unsigned metBy(const Node& node, const Vec3& from_M, const Vec3& to_M, bool is_long) noexcept UNDERACT_REAL_TIME {
  const PathInNode path = pathIn(node, from_M, to_M);
  unsigned met = 0;
  for (std::size_t child = 0; child < kChildren; ++child) {
    bool meets = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      meets &= static_cast<double>(node.low_N[axis][child]) <= path.high[axis] + path.wider;
      meets &= static_cast<double>(node.high_N[axis][child]) >= path.low[axis] - path.wider;
    }
    met |= (meets ? 1U : 0U) << child;
  }
  if (!is_long) return met;
  for (std::size_t child = 0; child < kChildren; ++child) {
    if ((met >> child & 1U) != 0U && isBeside(node, child, path)) met &= ~(1U << child);
  }
  return met;
}

/// Calls poll(face) for the faces whose boxes the way may meet. is_long: the way is much longer than a tick's. Whether
/// these were all.
template <class Visit>
bool eachOnSegment(const Surface& surface, const Vec3& from_M, const Vec3& to_M, bool is_long,
                   const Visit& visit) noexcept UNDERACT_REAL_TIME {
  std::array<std::int32_t, (kChildren - 1) * kMaxDepth + kChildren> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  for (int visits = 0; waiting > 0; ++visits) {
    if (visits == kMaxVisits) return false;
    const Node& node = surface.nodes[static_cast<std::size_t>(stack[--waiting])];
    const unsigned met = metBy(node, from_M, to_M, is_long);
    for (std::size_t child = 0; child < kChildren; ++child) {
      if ((met >> child & 1U) == 0U || node.children[child] == kNoChild) continue;
      if (node.children[child] >= 0) {
        stack[waiting++] = node.children[child];
      } else {
        visit(-1 - node.children[child]);
      }
    }
  }
  return true;
}

}  // namespace

int netCrossings(const Surface& surface, const Vec3& from_M, const Vec3& to_M) noexcept {
  if (from_M == to_M) return 0;
  const Sheared sheared(from_M, to_M);
  int sum = 0;
  eachOnSegment(surface, from_M, to_M, true, [&](std::int32_t face) noexcept UNDERACT_REAL_TIME {
    sum += shareAt(surface, face, CrossingDirection::Outwards, sheared, 0.0) < kInfinity ? 1 : 0;
    sum -= shareAt(surface, face, CrossingDirection::Inwards, sheared, 0.0) < kInfinity ? 1 : 0;
  });
  return sum;
}

bool isInside(const Surface& surface, const Vec3& q_M) noexcept {
  // To a point outside the bounds, in a direction that edges of ordinary meshes do not have.
  const Vec3 low = surface.low_M.cast<double>(), high = surface.high_M.cast<double>();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (q_M[axis] < low[axis] || q_M[axis] > high[axis]) return false;
  }
  return netCrossings(surface, q_M, q_M + 2.0 * (high - low).norm() * Vec3(0.5773, 0.2113, 0.7887)) > 0;
}

Crossing firstCrossing(const Surface& surface, CrossingDirection direction, const Vec3& from_M,
                       const Vec3& to_M) noexcept {
  Crossing crossing;
  if (from_M == to_M) return crossing;
  const Sheared sheared(from_M, to_M);
  const double slack = sheared.slack(surface);
  double first = kInfinity;
  crossing.is_whole = eachOnSegment(surface, from_M, to_M, false, [&](std::int32_t face) noexcept UNDERACT_REAL_TIME {
    const double share = shareAt(surface, face, direction, sheared, slack);
    if (share < first) {
      first = share;
      crossing.face = face;
    }
  });
  return crossing;
}

}  // namespace underact::mesh
