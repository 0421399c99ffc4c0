#pragma once
#include "core/arm/model.h"

namespace underact::arm {

/// The vertical plane of W in which an arm is mirrored for the other hand: all points whose coordinate `axis` (0: x,
/// 1: y) is at_m. It is parallel to an axis of W, so that a reflection changes the sign of one coordinate and no bit
/// more, where at_m is 0.
struct MirrorPlane {
  Eigen::Index axis = 0;
  double at_m = 0.0;
  bool operator==(const MirrorPlane&) const = default;
  /// The reflection of a position, m. Twice is the position itself, within an ulp of 2 at_m.
  Vec3 positionSeen(Vec3 p_W) const noexcept;
  /// The reflection of a direction with a sense, or of a velocity.
  Vec3 directionSeen(Vec3 direction_W) const noexcept;
};

/// Of a haptic device of the Omni's form, whose y is up: x = 0. Of any other arm, whose z is up: the plane through its
/// base that contains the way it faces. That is x of frame 0 of its table (of W, where the file has no table), or z of
/// frame 0 where x is upright (the base of such an arm hangs on a wall); taken as the axis of W nearest to it.
MirrorPlane mirrorPlane(const Model& model);

}  // namespace underact::arm
