#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/arm_picture.h"
#include "app/gui/view/dimple_picture.h"
#include "app/gui/view/orbit_camera.h"
#include "app/gui/view/pieces.h"
#include "core/arm/model.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

/// What moves: arm, stylus, targets with their error lines, the force arrow or, on a fault, the ring with a cross.
class HandPicture {
 public:
  static constexpr double kArrow_mm = 60.0;  // of the continuous force, of an arm of the Omni's size
  // A stylus that nobody holds, in its own frame T: a round tip at 0, the body along +z, towards the hand.
  static constexpr double kTip_mm = 2.2, kNeck_mm = 1.5, kBody_mm = 3.2, kTaper_mm = 15.0, kEnd_mm = 84.0;

  HandPicture();
  void setTheme(const Theme& theme);
  void setArm(const arm::Model& model);
  /// As those of the arm's picture.
  bool isReadingArm() const { return arm_.isReading(); }
  bool takeArmRead() { return arm_.takeRead(); }
  void setForceLimit(double continuous_N) { force_limit_N_ = continuous_N; }
  void setLineWidth(double device_pixels_per_pixel);
  void show(bool arm, bool target, bool force);

  /// The state of the arm in this tick. Joint angles that are not finite: the last pose stays.
  void present(const servo::Snapshot& snapshot);
  /// Outlines and markers as seen by the camera. size: of the picture, logical pixels.
  void update(const OrbitCamera& camera, const QSizeF& size);

  bool known() const { return arm_.known(); }  // a pose has come
  const Pose& X_WT() const { return arm_.X_WT(); }
  const ArmPicture& arm() const { return arm_; }
  double force_N() const { return force_N_; }
  bool limited() const { return limited_; }
  bool faulted() const { return faulted_; }

  /// In the order of drawing; targets() grows with the scene.
  std::vector<vtkActor*> solids() const;
  std::vector<vtkActor*> lines() const { return {arm_.outline(), outline_actor_, error_actor_}; }
  /// Over the tints.
  std::vector<vtkActor*> dimples() const { return dimple_.actors(); }
  std::size_t dimplesDrawn() const { return dimple_.dimples(); }
  /// Drawn over everything.
  std::vector<vtkActor*> marks() const { return {through_actor_, mark_actor_}; }
  /// A target marker for each constraint, and a dimple for each surface.
  void setScene(const scene::Description& scene);
  const std::vector<vtkSmartPointer<vtkActor>>& targets() const { return targets_; }

 private:
  void placeForce();
  void placeTargets();

  Theme theme_ = Theme::light();
  ArmPicture arm_;
  DimplePicture dimple_;
  double force_limit_N_ = 0.88;
  bool show_target_ = true, show_force_ = true;

  bool limited_ = false, faulted_ = false;
  double force_N_ = 0.0;
  double size_ = 1.0;  // of the arm, relative to the Omni
  Vec3 force_end_mm_ = Vec3::Zero(), head_mm_ = Vec3::Zero();
  bool arrow_ = false;
  std::vector<Vec3> held_mm_;

  vtkSmartPointer<vtkActor> shaft_, head_, bar_;
  std::vector<vtkSmartPointer<vtkActor>> targets_;
  Lines outlines_, errors_, through_, mark_;
  vtkSmartPointer<vtkActor> outline_actor_, error_actor_, through_actor_, mark_actor_;
};

}  // namespace underact::gui
