#pragma once
#include "core/arm/preset.h"
#include "core/extremes/input.h"

namespace underact::extremes {

// What rows that ask the arm draw.

/// Lengths: a real arm's, or of any scale.
arm::Geometry drawArm(Input& input);
/// Within a turn, beside the quarter turns where the arm is singular, seldom of 1e6 rad.
arm::JointAngles drawJoints(Input& input);

}  // namespace underact::extremes
