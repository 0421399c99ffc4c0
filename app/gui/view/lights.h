#pragma once
#include <array>

#include "core/base/types.h"

namespace underact::gui {

/// Directions to the key and the fill light, right, up and back of the camera, and their strengths: they follow it.
inline const std::array<Vec3, 2> kLights{Vec3(-0.45, 0.75, 0.9), Vec3(0.9, -0.1, 0.5)};
inline constexpr std::array<double, 2> kLightStrengths{0.95, 0.34};

}  // namespace underact::gui
