#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "app/gui/kit/background.h"
#include "app/gui/kit/theme.h"
#include "app/gui/view/arm_solids.h"
#include "app/gui/view/lights.h"
#include "app/gui/view/orbit_camera.h"
#include "app/gui/view/solid_mesh.h"

namespace underact::gui {

/// A rod as the arm's shadow knows it, m, in W.
struct ShadowRod {
  Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();
  double from_radius_m = 0.0, to_radius_m = 0.0;
};

/// An arm of any form as solids in one pose.
class ArmPicture {
 public:
  ArmPicture();
  /// Meshes among the solids of its file are read in another thread; until takeRead() it is drawn without them.
  void setArm(const arm::Model& model);
  bool isReading() const { return reading_ != nullptr; }
  /// Shows the meshes, once, when they are read; true then.
  bool takeRead();
  /// What is wrong with those that were read and are not drawn.
  const Problems& problems() const { return problems_; }
  void setTheme(const Theme& theme);
  void setLineWidth(double device_pixels_per_pixel);
  void show(bool arm, bool stylus);
  /// q: rad or m, one for each joint. Values that are not finite: false, and the last pose stays.
  bool present(std::span<const double> q);
  /// Outlines as seen by the camera.
  void update(const OrbitCamera& camera);

  bool known() const { return known_; }
  const Pose& X_WT() const { return X_WT_; }
  const ArmStand& stand() const { return arm_.stand; }
  /// Where a hand takes the stylus, m: its tip and its other end, in W.
  std::array<Vec3, 2> stylus_W() const;
  /// The places of the joints, mm, and the foot: what a picture of the whole arm has to show.
  std::vector<Vec3> extent_mm() const;
  std::vector<ShadowRod> shadowRods() const;
  /// Those of what a hand takes besides the stylus: its gimbal, the last three links of an arm of six joints.
  std::vector<ShadowRod> gimbalRods() const;
  /// One actor for each link; others after setArm().
  std::vector<vtkActor*> solids() const;
  vtkActor* outline() const { return outline_actor_; }

 private:
  std::vector<ShadowRod> rodsFrom(std::size_t first_link) const;
  void build();
  void place();

  Theme theme_ = Theme::light();
  ArmSolids arm_;
  chain::Chain chain_;
  arm::Model model_;
  std::unique_ptr<Background<ArmMeshes>> reading_;
  Problems problems_;
  bool show_arm_ = true, show_stylus_ = true, known_ = false;
  Pose X_WT_ = Pose::Identity();
  std::vector<Pose> X_WLinks_;  // of the base first
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  Lines outlines_;
  vtkSmartPointer<vtkActor> outline_actor_;
};

/// The colours of an arm.
Finishes armFinishes(const Theme& theme);

}  // namespace underact::gui
