#pragma once
#include "core/manipulator/manipulator.h"

namespace underact::manipulator {

/// What closedForm() gives: a value for each joint, rad or m.
struct Closed {
  Values theta{};
  bool is_unique = false;  // false: every place of the circle or sphere is as good; theta is near's
};

/// The joints of least energy over all of the chain, by the manipulator's closed form. near: of several equal values
/// (turns of 2 pi, the two ways to a point of a sphere) those nearest to it. Energy within 64 ulp of the least (see
/// evaluate()). Cost: constant. manipulator.closed must be there. Source: errata section 6, n* = normalise(kp R (p - C)
/// + ko z); with z of V at any angle to the radius on circle and cylinder, both parts being turned by the same joint.
Closed closedForm(const Manipulator& manipulator, const Pose& X_WT, const Values& near) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::manipulator
