#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/chain/chain.h"

namespace underact::chain {

/// A displacement within a plane: about the normal by an angle, then so that a point comes to a place.
struct PlanarMotion {
  double angle_rad = 0.0;
  Vec3 p_home = Vec3::Zero();  // this point
  Vec3 p_moved = Vec3::Zero();
};

/// Joints that move the tip in a plane: revolute ones about its normal, prismatic ones along it; and up to one that
/// slides along the normal (a SCARA's quill). Made by planarArm().
struct PlanarArm {
  Vec3 normal_W = Vec3::UnitZ();
  std::vector<Joint> level;  // the joints within the plane, one to three; their axes along +normal where they turn
  std::vector<std::size_t> which;    // the chain's joint that each of them is
  std::vector<double> sign;          // -1 where the chain's axis is opposed
  std::optional<std::size_t> quill;  // the chain's joint along the normal
  double quill_sign = 1.0;
};

/// The chain as such an arm. None where an axis stands askew, where two slide along the normal, or where more than
/// three joints share the plane, none turns, or two slide in the same direction.
std::optional<PlanarArm> planarArm(const Chain& chain);

/// Values of the joints within the plane, at most two sets; not polished.
struct PlanarAnswers {
  std::array<std::array<double, 3>, 2> all{};
  std::size_t count = 0;
};
/// Three joints for a motion; with two joints the angle is not asked for, with one only the nearest value is found.
PlanarAnswers solvePlanar(const Vec3& normal_W, const std::vector<Joint>& level, const PlanarMotion& wanted) noexcept;

}  // namespace underact::chain
