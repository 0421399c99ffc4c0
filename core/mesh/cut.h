#pragma once
#include <array>
#include <cstdint>

#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/mesh/surface.h"

namespace underact::mesh {

/// A set of nodes of a surface's tree. Every face outside them is at least `reach` away from q, so that a search about
/// q may begin at them and not at the root and still finds the global minimum.
struct Cut {
  static constexpr std::size_t kMax = 12;
  Vec3 q_M = Vec3::Zero();
  double reach = 0.0;         // 0: it says nothing
  std::uint64_t surface = 0;  // its mark
  std::uint32_t served = 0;   // searches since it was made
  std::uint32_t size = 0;     // of the nodes
  std::array<std::int32_t, kMax> nodes{};
};

/// Whether every face outside the cut is at least as far from q_M as distance. False for any cut that was not made for
/// this surface.
bool holds(const Cut& cut, const Surface& surface, const Vec3& q_M, double distance) noexcept UNDERACT_REAL_TIME;

/// The lowest level with few enough nodes within reach of q_M, or the root. visits: goes up by the nodes looked at.
/// Cost: at most kMax nodes a level.
Cut makeCut(const Surface& surface, const Vec3& q_M, double reach, int& visits) noexcept UNDERACT_REAL_TIME;

/// The next cut, when one no longer holds: for some more searches as far apart as those that it served. distance: of a
/// point on the surface.
Cut nextCut(const Cut& cut, const Surface& surface, const Vec3& q_M, double distance,
            int& visits) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
