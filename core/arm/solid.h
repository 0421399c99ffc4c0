#pragma once
#include <cstddef>
#include <string>
#include <variant>

#include "core/base/result.h"
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
/// The surface in a mesh file, whose frame is S. solid_place.h says which file its name means.
struct MeshSolid {
  std::string name;  // as the arm's file has it: relative to that file's folder, or package://NAME/...
  Vec3 m_per_unit = Vec3::Constant(1e-3);  // along each axis; one below 0 mirrors it
  SourceLocation place = {};               // of the name
};
/// What a solid is.
using SolidForm = std::variant<BoxSolid, CylinderSolid, CapsuleSolid, SphereSolid, MeshSolid>;

/// A solid that moves with a link: 0 is the base, i the link behind joint i.
struct LinkSolid {
  std::size_t link = 0;
  Pose X_WS = Pose::Identity();  // with all joints at 0
  SolidForm form;
};

/// The most that an arm has.
inline constexpr std::size_t kMaxSolids = 256;
/// The longest name of a mesh file, bytes.
inline constexpr std::size_t kLongestMeshName = 1024;
/// Factors of a mesh are at most that, and at least its inverse, m.
inline constexpr double kMaxMetresPerUnit = 1e3, kMinMetresPerUnit = 1e-9;

}  // namespace underact::arm
