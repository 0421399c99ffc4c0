#pragma once
#include "core/manipulator/manipulator.h"

namespace underact::manipulator {

/// What closedForm() gives: a value for each joint, rad or m.
struct Closed {
  Values theta{};
  bool is_unique = false;  // false: all points of the circle or sphere are equal; theta is near
};

/// The joints of least energy in the whole joint space, by the manipulator's closed form. near: of several equal values
/// (turns of 2 pi, the two configurations for a point of a sphere) those nearest to it. Energy within 64 ulp of the
/// least (see evaluate()). Cost: constant. manipulator.closed must have a value. Source: errata section 6, n* =
/// normalise(kp R (p - C) + ko z); with z of V at any angle to the radius on circle and cylinder, as one joint rotates
/// both.
Closed closedForm(const Manipulator& manipulator, const Pose& X_WT, const Values& near) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::manipulator
