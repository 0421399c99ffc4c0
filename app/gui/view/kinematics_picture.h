#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <optional>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/model/kinematics_now.h"
#include "app/gui/model/numbered_solutions.h"
#include "app/gui/view/ghost_arm.h"
#include "app/gui/view/orbit_camera.h"
#include "app/gui/view/pieces.h"
#include "app/gui/view/workspace_picture.h"
#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/arm/model.h"

namespace underact::gui {

/// Which of these places it is; a new one is appended.
std::size_t placeAmong(std::vector<Vec3>& places_mm, const Vec3& p_mm);
/// dash_mm: of a dash, and of a gap.
void addDashes(Lines& lines, const Vec3& a_mm, const Vec3& b_mm, double dash_mm, const QColor& colour);

/// For teaching: the link frames, the inverse solutions as ghosts of the arm, and the ellipsoids at the tip to which a
/// ball of joint rotations and one of joint torques map. A function of the arm, its joints, the chosen solution and the
/// theme. The highlighted solution is a translucent solid arm, and the ellipsoids are translucent surfaces. The other
/// solutions of an arm that solvesInTick() are lines, since they share their links; those of any other arm are
/// translucent, too, as one surface, since each one costs frames on software GL.
class KinematicsPicture {
 public:
  static constexpr double kTurn_rad = 0.25;  // motion ellipsoid: displacement of the tip for this joint rotation
  static constexpr double kTorque_N_m = kOmniTorque_N_m;  // force ellipsoid, at the scale of the arrow
  // Of an arm of the Omni's size: a dash, the joints of the highlighted ghost, and a ghost's number from its elbow.
  static constexpr double kDash_mm = 5.0, kHollow_mm = 3.6, kNumber_mm = 16.0;
  static constexpr double kLongest_mm = 160.0;  // at a singularity the force ellipsoid is unbounded: cut here

  KinematicsPicture();
  void setTheme(const Theme& theme);
  void setArm(const arm::Preset& preset, const arm::Model& model);
  void setForceLimit(double continuous_N) { force_limit_N_ = continuous_N; }
  void setLineWidth(double device_pixels_per_pixel);
  void show(bool link_frames, bool ghosts, bool motion_ellipsoid, bool force_ellipsoid);
  /// The number of the highlighted solution, 0: none, and the progress of its ghost from the current configuration:
  /// share 0 to 1.
  void choose(int number) { chosen_ = number; }
  void setShare(double share) { share_ = share; }
  /// Angles that are not finite: the last ones stay.
  void present(const arm::JointAngles& q_rad);
  /// As seen by the camera; builds lines and labels.
  void update(const OrbitCamera& camera);

  std::vector<vtkActor*> lines() const { return {thin_actor_}; }
  // Link frames, whose axes lie in the links and in the stylus, and the highlighted ghost: drawn over everything.
  std::vector<vtkActor*> marks() const { return {frame_actor_, mark_actor_}; }
  /// Drawn with the tints.
  std::vector<vtkActor*> surfaces() const { return {ghost_.actor(), others_.actor(), motion_actor_, force_actor_}; }
  const std::vector<Label>& labels() const { return labels_; }
  std::vector<Vec3> extent_mm() const;
  /// Of the highlighted solution; empty: there is none.
  std::vector<Vec3> chosenExtent_mm() const;
  std::size_t solutionsDrawn() const { return ghosts_ && known_ ? solutions().all.size() : 0; }
  std::optional<arm::JointAngles> chosen_rad() const;

 private:
  void addFrames();
  void addSolutions();
  void addSolution(const NumberedSolution& solution, double aside_mm);
  void addChosen(const arm::JointAngles& q_rad, const OrbitCamera& camera);
  // Of solutions that do not share their links: kinematics_ghosts.cpp.
  void addArms();
  void addChosenArm(const arm::JointAngles& q_rad, const OrbitCamera& camera);
  std::size_t apartPoint() const;
  std::vector<Vec3> skeletonExtent_mm(const arm::JointAngles& q_rad) const;
  void addEllipsoids();
  void addEllipsoid(vtkActor& surface, const arm::Dexterity& dexterity, const Vec3& half_mm, const QColor& colour,
                    const QString& letter);
  /// The numbers of the solutions that share a place, where label_mm() puts them.
  void addNumbers(const std::function<Vec3(const NumberedSolution&)>& place_mm,
                  const std::function<Vec3(const Vec3& place_mm)>& label_mm);
  std::vector<double> aside_mm() const;
  Vec3 outwards(const Vec3& elbow_mm) const;   // a direction, away from the middle of shoulder and tip
  const NumberedSolutions& solutions() const;  // of X_WT_
  bool shareLinks() const { return arm::solvesInTick(geometry_); }  // the solutions

  Theme theme_ = Theme::light();
  arm::Geometry geometry_;
  arm::Model model_;
  SolutionFinder finder_;
  double force_limit_N_ = 0.88, torque_N_m_ = kTorque_N_m;
  bool frames_ = false, ghosts_ = false, motion_ = false, force_ = false;
  int chosen_ = 0;
  double share_ = 1.0;

  bool known_ = false;
  arm::JointAngles q_rad_{};
  Pose X_WT_ = Pose::Identity();
  mutable std::optional<NumberedSolutions> solutions_;  // found when somebody asks: a search takes a millisecond

  Lines thin_, frame_, mark_;
  vtkSmartPointer<vtkActor> thin_actor_, frame_actor_, mark_actor_, motion_actor_, force_actor_;
  GhostArm ghost_, others_;  // of the highlighted solution, and of the others
  std::vector<Label> labels_;
};

}  // namespace underact::gui
