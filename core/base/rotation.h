#pragma once
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact {

/// The rotation vector w, rad, |w| <= pi, with R = e^[w]: the matrix logarithm. R: a rotation. Within 4 ulp of pi, as
/// is e^[w]; for half a turn either of the two axes. Not finite in, not finite out. Source: Lynch and Park, Modern
/// Robotics, section 3.2.3.
Vec3 rotationVector(const Mat3& R) noexcept UNDERACT_REAL_TIME;

}  // namespace underact
