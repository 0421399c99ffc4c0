#pragma once
#include "core/arm/preset.h"
#include "core/extremes/input.h"

namespace underact::extremes {

// What rows that ask the arm draw.

/// Lengths: a real arm's, or 2^-size to 2^size m; the base in the origin or beside it.
arm::Geometry drawArm(Input& input, int size = 40);
/// Within a turn, beside the quarter turns where the arm is singular, seldom of 1e6 rad.
arm::JointAngles drawJoints(Input& input);

}  // namespace underact::extremes
