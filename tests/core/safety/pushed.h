#pragma once
#include "core/safety/gate.h"

namespace underact::safety {

inline const Vec3 kZero = Vec3::Zero();

inline GateInput push(const Vec3& f_T_W) {
  return {f_T_W, true, false, {}};
}

/// Three driven joints far from their stops, that move the tip by the columns of J_p.
inline Motion threeJoints(const Mat3& J_p) {
  Motion motion{};
  motion.count = 3;
  for (Eigen::Index joint = 0; joint < 3; ++joint)
    motion.joints[static_cast<std::size_t>(joint)] = {J_p.col(joint), kZero, kInfinity, kInfinity};
  return motion;
}

/// A gate whose ramp is over.
inline GateState open() {
  GateState state;
  state.level = 1.0;
  return state;
}

}  // namespace underact::safety
