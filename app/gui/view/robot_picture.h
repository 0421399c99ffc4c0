#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/ghost_arm.h"
#include "app/gui/view/orbit_camera.h"
#include "app/gui/view/pieces.h"
#include "app/gui/view/robot_figure.h"
#include "app/gui/view/workspace_picture.h"
#include "core/scene/description.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

/// The virtual robots of a scene in the tick shown: hollow joints, links, base and end effector V, the directions in
/// which V can move, and the moment, which hardly any arm can render. Before the first tick, and until the servo has
/// taken up an edited chain, a robot is in its home pose. Lines over translucent solids.
class RobotPicture {
 public:
  static constexpr double kWay_mm = 15.0;              // the directions in which V can move: half their length
  static constexpr double kArc_rad_per_N_mm = 0.0175;  // the moment's arc: a degree for each N mm,
  static constexpr double kLongestArc_rad = 5.24;      // at most 300 of them

  RobotPicture();
  void setScene(const scene::Description& scene);
  void setTheme(const Theme& theme) { theme_ = theme; }
  void setLineWidth(double device_pixels_per_pixel);
  void show(bool robots) { show_ = robots; }
  void present(const servo::Snapshot& snapshot);
  /// As seen by the camera; builds lines and labels.
  void update(const OrbitCamera& camera);

  std::vector<vtkActor*> lines() const { return {thin_actor_, thick_actor_}; }
  /// Drawn with the tints; others after setScene().
  std::vector<vtkActor*> surfaces() const;
  const std::vector<Label>& labels() const { return labels_; }
  /// End effectors and joints in their current pose.
  std::vector<Vec3> extent_mm() const;
  std::size_t robotsDrawn() const { return show_ ? robots_.size() : 0; }

 private:
  struct Robot {
    std::size_t index = 0;  // of its constraint
    manipulator::Manipulator manipulator;
    manipulator::Values theta{};
    Vec3 moment_W = Vec3::Zero();
    std::shared_ptr<GhostArm> body = std::make_shared<GhostArm>();
  };
  void add(const Robot& robot, const OrbitCamera& camera);
  void addJoint(const JointFigure& joint, double size_mm, const Vec3& eye_mm);
  void addSpring(const JointFigure& joint, double size_mm);
  void addBase(const Vec3& p_mm, double size_mm, const Vec3& right_W);
  void addTip(const Robot& robot, const Pose& X_WV, const OrbitCamera& camera);
  void addDirections(const Robot& robot, const Vec3& tip_mm, const OrbitCamera& camera);
  void addMoment(const Vec3& moment_W, const OrbitCamera& camera);

  Theme theme_ = Theme::light();
  bool show_ = true;
  std::vector<Robot> robots_;
  bool known_ = false;    // a tick has arrived
  bool is_sent_ = false;  // the arm renders the moment
  Vec3 p_WT_ = Vec3::Zero();
  Lines thin_, thick_;
  vtkSmartPointer<vtkActor> thin_actor_, thick_actor_;
  std::vector<Label> labels_;
};

}  // namespace underact::gui
