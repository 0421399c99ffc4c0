#pragma once
#include <optional>

#include "app/gui/feature/panel.h"
#include "app/gui/model/kinematics_now.h"
#include "core/arm/model.h"
#include "core/sim/hand.h"

class QLabel;
class QVBoxLayout;

namespace underact::gui {

class AnglesSection;
class DhSection;
class JacobianSection;
class JointsSection;
class SingularitiesSection;
class SolutionsSection;

/// Kinematics for teaching: joints that can be moved while the servo is stopped, distance to singularities, inverse
/// solutions, DH table, angle conventions, Jacobian; and the layers of the view that show them. A function of the
/// snapshot; core computes. The numbers change ten times a second of servo time, and only while they are visible.
class KinematicsPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    Actions& actions;
    SceneView& view;
    Player& player;
    ArmChoice& arms;
  };
  KinematicsPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void addActions();
  void buildSwitches(QVBoxLayout* column);
  void sceneOpened();
  bool showAll(bool on);
  bool isDue(const servo::Snapshot& snapshot);
  bool setJoint(int joint, double angle_deg, bool relative);
  bool moveToSolution(int number);
  void moveArm(const arm::JointAngles& q_rad);
  void settleArm(std::int64_t now_ns);
  void travel(std::int64_t now_ns);
  bool mayMove() const;
  bool leadsArm() const;
  bool showSolution(int number);
  QString whyNotTo(int number) const;
  QString whyNotAsTyped() const;

  Parts parts_;
  QLabel* scale_ = nullptr;
  JointsSection* joints_ = nullptr;
  SingularitiesSection* singularities_ = nullptr;
  SolutionsSection* solutions_ = nullptr;
  DhSection* dh_ = nullptr;
  AnglesSection* angles_ = nullptr;
  JacobianSection* jacobian_ = nullptr;

  arm::Model model_;  // of the scene's arm
  arm::Preset preset_;
  SolutionFinder finder_;
  arm::Geometry geometry_;
  arm::JointLimits limits_;
  servo::Mode mode_ = servo::Mode::Running;
  arm::JointAngles q_rad_{};    // of the last snapshot
  std::int64_t shown_ns_ = -1;  // of the tick whose numbers are shown; -1: none
  servo::Mode shown_mode_ = servo::Mode::Running;

  // The joint angles commanded last, as long as nothing else moves the hand: friction stops the arm a little short of
  // them, so steps from the actual angles would never add up.
  arm::JointAngles setpoint_rad_{};
  std::optional<sim::HandSetpoint> setpoint_;
  std::int64_t commanded_ns_ = -1;
  /// On the way to a solution.
  struct Travel {
    arm::JointAngles from{}, to{};
    std::int64_t began_ns = -1;
  };
  std::optional<Travel> travel_;
  bool is_settled_ = true;      // the arm stands where it was commanded to
  std::int64_t rests_ns_ = -1;  // since when it has the angles of the last snapshot
};

}  // namespace underact::gui
