#pragma once
#include "core/arm/sample.h"
#include "core/base/real_time.h"

namespace underact::arm {

/// The joints at a share of the way from one posture to another, 0 to 1 (beyond: held there). Every joint turns evenly
/// and through the angles between, never the other way round past half a turn: a joint with limits cannot go there.
/// Not finite in, not finite out. Cost: constant.
JointAngles onTheWay(const JointAngles& from_rad, const JointAngles& to_rad, double share) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
