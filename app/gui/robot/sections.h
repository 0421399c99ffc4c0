#pragma once
#include <vector>

#include "app/gui/kit/section.h"
#include "core/scene/description.h"
#include "core/tick/report.h"

class QPushButton;

namespace underact::gui {

class EditTable;
class Readout;

// The sections of the Robot panel. Each shows a robot and signals requested edits; the panel edits the scene.

/// The result of the solver in the tick shown.
class RobotNowSection : public Section {
  Q_OBJECT
 public:
  explicit RobotNowSection(QWidget* parent = nullptr);
  /// is_sent: the arm renders the moment.
  void setRobot(const manipulator::Manipulator& manipulator, bool is_sent);
  void present(const tick::ConstraintReport& held);

 private:
  Readout* readout_;
  std::vector<int> joint_rows_;
  manipulator::Manipulator manipulator_;
  int found_ = 0, left_ = 0, energy_ = 0, moment_ = 0, target_ = 0, better_ = 0;
  bool is_sent_ = false;
};

/// The table of joints, with buttons to add, remove and move one.
class ChainSection : public Section {
  Q_OBJECT
 public:
  explicit ChainSection(QWidget* parent = nullptr);
  void present(const scene::VirtualManipulator& robot);
  int selected() const;  // from 0
  void select(int joint);
 signals:
  void typed(int joint, int field, const QString& text);
  void addAsked(int after);
  void removeAsked(int joint);
  void moveAsked(int joint, int by);

 private:
  void showButtons();
  EditTable* table_;
  QPushButton *add_, *remove_, *up_, *down_;
};

/// The home pose of the end effector V, with all joints at 0.
class HomeSection : public Section {
  Q_OBJECT
 public:
  explicit HomeSection(QWidget* parent = nullptr);
  /// angles_deg: of the orientation, about x, then y, then z.
  void present(const Eigen::Matrix4d& X_WV_home, const Vec3& angles_deg);
 signals:
  void typed(int row, int axis, const QString& text);  // row 0: position, 1: orientation

 private:
  EditTable* table_;
};

}  // namespace underact::gui
