#include "core/target/friction.h"

namespace underact::target {

bool slides(const Friction& friction, const Vec3& p_WT, const Vec3& p_WP, Grip& grip) noexcept {
  if (!grip.holds) {
    grip = {true, p_WP};
    return false;
  }
  const Vec3 along_W = grip.p_WG - p_WP;
  const double way_m = along_W.norm(), depth_m = (p_WP - p_WT).norm();
  if (way_m <= friction.static_share * depth_m) return false;
  grip.p_WG = p_WP + (friction.dynamic_share * depth_m / way_m) * along_W;
  return true;
}

}  // namespace underact::target
