#pragma once
#include "core/safety/gate.h"

namespace underact::safety {

inline const Vec3 kZero = Vec3::Zero();

inline GateInput push(const Vec3& f_T_W) {
  return {f_T_W, true, false, {}};
}

/// A gate whose ramp is over.
inline GateState open() {
  GateState state;
  state.level = 1.0;
  return state;
}

}  // namespace underact::safety
