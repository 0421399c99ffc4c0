#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <span>
#include <vector>

#include "app/gui/view/arm_solids.h"
#include "app/gui/view/solid_mesh.h"
#include "core/arm/sample.h"

namespace underact::gui {

/// A chain as translucent solids of one colour: a virtual robot, or the arm in one or several other configurations. One
/// surface, of which only the part nearest to the eye is drawn, so that links do not show through each other.
class GhostArm {
 public:
  static constexpr double kOpacity = 0.28;

  GhostArm();
  /// A virtual robot: housings and links.
  void setChain(const chain::Chain& chain);
  /// An arm without its base, which does not move: from its file's solids where it has them. Of the Omni's form without
  /// its turret, which would cover the way that it faces.
  void setArm(const arm::Model& model);
  void setColour(const QColor& colour) { gui::setColour(*actor_, colour); }
  void setOpacity(double opacity);
  /// Of several ghosts, one with a higher number is behind those that have the same place; all are behind the arm.
  void setOrder(int number);
  /// q: rad or m, one for each joint. Not finite: hidden.
  void present(std::span<const double> q);
  /// Shows it in several configurations at once; none: hidden. Those that were shown last cost nothing.
  void presentAll(const std::vector<arm::JointAngles>& configurations);
  void hide() { actor_->SetVisibility(false); }
  vtkActor* actor() const { return actor_; }

  /// The points from joint to joint that the links go through, two of each joint, and the tip, mm; some are in one
  /// place. q as in present(), finite.
  std::vector<Vec3> skeleton_mm(std::span<const double> q) const;
  /// Of the arm, relative to the Omni; lengths of marks scale with it.
  double size() const { return size_; }

 private:
  void take(ArmSolids arm, const chain::Chain& chain);
  std::vector<Pose> linksAt(std::span<const double> q) const;

  chain::Chain chain_;
  std::vector<ArmSolid> solids_;
  std::vector<DrawnAxis> axes_;
  double size_ = 1.0;
  int order_ = 0;
  std::vector<arm::JointAngles> shown_;  // of which data_ is
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> actor_;
};

}  // namespace underact::gui
