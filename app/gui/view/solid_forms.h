#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "app/gui/view/pieces.h"
#include "core/base/types.h"

namespace underact::gui {

// The forms that arms are drawn from, m, in W.

/// What a part of an arm is made of: it decides the colour.
enum class Finish : std::uint8_t { Shell, Trim, Metal, Pen };
inline constexpr std::size_t kFinishes = 4;

/// A surface of revolution about z of its own frame S.
struct TurnedForm {
  Pose X_WS = Pose::Identity();
  std::vector<Ring> profile;  // from bottom to top
};

/// A round rod that is bent to an arc: from the direction `from_W`, seen from its centre, towards `to_W`, which is
/// perpendicular to it.
struct BentForm {
  Vec3 p_WC = Vec3::Zero();
  Vec3 from_W = Vec3::UnitX();
  Vec3 to_W = Vec3::UnitY();
  double radius_m = 0.0;  // of the arc
  double turn_rad = 0.0;
  double rod_m = 0.0;  // radius of the rod
};

/// A box, its edges along the axes of its own frame S.
struct BoxForm {
  Pose X_WS = Pose::Identity();
  Vec3 half_m = Vec3::Zero();
};

struct ArmMesh;

/// A mesh in its own frame S.
struct MeshForm {
  Pose X_WS = Pose::Identity();
  Vec3 m_per_unit = Vec3::Ones();  // one below 0 mirrors it
  std::shared_ptr<const ArmMesh> mesh;
};

using Form = std::variant<TurnedForm, BentForm, BoxForm, MeshForm>;

/// A solid that moves with a link: 0 is the base, i the link behind joint i.
struct ArmSolid {
  std::size_t link = 0;
  Finish finish = Finish::Shell;
  Form form;
};

/// A frame at p_W whose z points along `z_W` (of length 1).
Pose frameAlong(const Vec3& p_W, const Vec3& z_W);

/// Profiles from z = from_m to to_m: a rod whose ends are rounded by `edge_m`, and one with hemispheres beyond both
/// ends.
std::vector<Ring> roundedRod(double from_m, double to_m, double radius_m, double edge_m);
std::vector<Ring> taperedRod(double from_m, double to_m, double from_radius_m, double to_radius_m);

/// The outward normals (radial, axial) at both ends of each strip of a profile: smooth across strips that meet at less
/// than 45 degrees.
std::vector<std::array<Eigen::Vector2d, 2>> stripNormals(std::span<const Ring> profile);

}  // namespace underact::gui
