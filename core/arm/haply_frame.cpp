#include "core/arm/haply_frame.h"

namespace underact::arm {

Vec3 workspaceMiddleInHaply() noexcept {
  return {0.0, -0.12, 0.15};
}

/// x stays, the y axis of W is their z, and its z axis, towards the person, is their -y.
Mat3 haplyFromWorkspace() noexcept {
  Mat3 R_HW;
  R_HW << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
  return R_HW;
}

Vec3 haplyPlaceFromWorkspace(const Vec3& p_W) noexcept {
  return haplyFromWorkspace() * p_W + workspaceMiddleInHaply();
}

Vec3 workspacePlaceFromHaply(const Vec3& p_H) noexcept {
  return haplyFromWorkspace().transpose() * (p_H - workspaceMiddleInHaply());
}

}  // namespace underact::arm
