#pragma once
#include <cstddef>
#include <variant>

#include "core/base/types.h"

namespace underact::arm {

// What an arm looks like, where its file says so; for drawing alone. Each about the middle of its own frame S, m.

/// A box, its edges along the axes of S.
struct BoxSolid {
  Vec3 size_m = Vec3::Zero();
};
/// A cylinder about z of S.
struct CylinderSolid {
  double radius_m = 0.0, length_m = 0.0;
};
/// A cylinder about z of S with a half sphere at each end, which its length does not include.
struct CapsuleSolid {
  double radius_m = 0.0, length_m = 0.0;
};
/// A ball.
struct SphereSolid {
  double radius_m = 0.0;
};
/// What a solid is.
using SolidForm = std::variant<BoxSolid, CylinderSolid, CapsuleSolid, SphereSolid>;

/// A solid that moves with a link: 0 is the base, i the link behind joint i.
struct LinkSolid {
  std::size_t link = 0;
  Pose X_WS = Pose::Identity();  // with all joints at 0
  SolidForm form;
};

/// The most that an arm has.
inline constexpr std::size_t kMostSolids = 256;

}  // namespace underact::arm
