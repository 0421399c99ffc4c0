#pragma once
#include "core/arm/preset.h"

namespace underact::arm {

inline const Preset& thesis() {
  return *findPreset("omni-thesis");
}

}  // namespace underact::arm
