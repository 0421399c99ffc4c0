#pragma once
#include <vector>

#include "app/gui/view/arm_mesh.h"
#include "app/gui/view/solid_forms.h"
#include "core/arm/model.h"

namespace underact::gui {

/// Where an arm stands, from its file: which way is up, how high the desk is, and its size. A haptic device of the
/// Omni's form has y up, as its workspace has; any other arm z, as its base has.
struct ArmStand {
  Mat3 R_WD = Mat3::Identity();  // the desk's frame D: x to the right, y up, z towards the user
  Vec3 p_WG = Vec3::Zero();      // the point of the desk under the first joint
  Vec3 p_DTop = Vec3::Zero();    // the middle of the desk's top, from there
  double size = 1.0;             // of the arm, relative to the Omni: lengths of marks scale with it
  Vec3 up_W() const { return R_WD.col(1); }
};

/// The joints of an arm as drawn, with all joints at 0: each axis enters at the point nearest to the axis before it and
/// is left at the one nearest to the axis after it. Where parallel axes leave that open: straight across.
struct DrawnAxis {
  chain::JointType type = chain::JointType::Revolute;
  Vec3 axis_W = Vec3::UnitZ();
  Vec3 in_W = Vec3::Zero();
  Vec3 out_W = Vec3::Zero();
  double radius_m = 0.0;  // of its housing: the more there is to carry behind it, the larger
};

/// An arm of 1 to kMaxJoints joints as solids, with all joints at 0. Posed by the displacement of each link
/// (chain::forward()).
struct ArmSolids {
  ArmStand stand;
  std::vector<DrawnAxis> axes;
  std::vector<ArmSolid> solids;
  // The stylus, or the tool's last part, in W with all joints at 0: from the tip to where a hand takes it.
  Vec3 p_WTip = Vec3::Zero(), p_WEnd = Vec3::Zero();
};

ArmStand standOf(const arm::Model& model);
std::vector<DrawnAxis> drawnAxes(const arm::Model& model);
/// Base, housings, links, and what carries the tip: a gimbal with a stylus where the last three axes meet in the tip, a
/// pointed tool elsewhere. An arm whose file has solids is drawn by those, and by its meshes that are read; where none
/// of them can be drawn, as any other.
ArmSolids solidsOf(const arm::Model& model, const ArmMeshes& meshes = {});

/// Housings and links alone, to the tip: of a virtual robot, which has neither base nor stylus.
ArmSolids chainSolids(const arm::Model& model);

/// A gimbal about the tip, and a stylus in it. Inside the room.
void addGimbal(ArmSolids& arm, const arm::Model& model);
void addStylus(ArmSolids& arm, const arm::Model& model);
/// The parts that stand on the desk and carry joint 1. Inside the room.
void addBase(ArmSolids& arm, bool is_device);

/// The Omni's reach, m: the unit of ArmStand::size.
inline constexpr double kOmniReach_m = 0.27686;

}  // namespace underact::gui
