#pragma once
#include "core/base/types.h"

namespace underact::control {

inline constexpr double kTick_s = 1e-3;
inline const Vec3 kZero = Vec3::Zero();

}  // namespace underact::control
