#pragma once
#include <optional>
#include <vector>

#include "app/gui/kit/section.h"
#include "app/gui/kit/value_row.h"
#include "core/scene/description.h"
#include "core/tick/report.h"

class QComboBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace underact::gui {

class EditTable;
class Readout;

// The sections of the Robot panel. Each shows a robot and says what is asked of it; the panel edits the scene.

/// What the tip pulls with: the turning stiffness, what of the stylus's turn it follows, the force law.
class PullSection : public Section {
  Q_OBJECT
 public:
  explicit PullSection(QWidget* parent = nullptr);
  /// own_ko: the scene's value; none: it has none.
  void present(const scene::VirtualManipulator& robot, const std::optional<double>& own_ko_N_mm_per_rad);
 signals:
  void koAsked(double ko_N_mm_per_rad, bool fresh);
  void orientationAsked(underact::manipulator::Orientation orientation);
  void lawAsked(underact::manipulator::ForceLaw law);

 private:
  ValueRow* ko_;
  QComboBox *orientation_, *law_;
};

/// Which way the joints are found.
class SolverSection : public Section {
  Q_OBJECT
 public:
  explicit SolverSection(QWidget* parent = nullptr);
  void present(const scene::Solver& solver);
 signals:
  void methodAsked(underact::scene::SolverMethod method);
  void stepsAsked(int max_steps);
  void toleranceAsked(const QString& text);

 private:
  QComboBox* method_;
  QSpinBox* steps_;
  QLineEdit* tolerance_;
};

/// What the solver does in the tick that is shown.
class RobotNowSection : public Section {
  Q_OBJECT
 public:
  explicit RobotNowSection(QWidget* parent = nullptr);
  void setRobot(const manipulator::Manipulator& manipulator);
  void present(const tick::Held& held);

 private:
  Readout* readout_;
  std::vector<int> joint_rows_;
  manipulator::Manipulator manipulator_;
  int found_ = 0, left_ = 0, energy_ = 0, moment_ = 0, target_ = 0, better_ = 0;
};

/// The joints, all of them typed, with buttons to add, take away and move one.
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

/// Where the tip V is while all joints are at 0, and how it is turned there.
class HomeSection : public Section {
  Q_OBJECT
 public:
  explicit HomeSection(QWidget* parent = nullptr);
  void present(const Eigen::Matrix4d& X_WV_home);
 signals:
  void typed(int row, int axis, const QString& text);  // row 0: place, 1: turn

 public:
  /// The three angles that are shown, degrees.
  const Vec3& angles_deg() const { return angles_deg_; }
  void keepAngles(const Vec3& angles_deg) { angles_deg_ = angles_deg; }

 private:
  EditTable* table_;
  // As they were typed: at ry = 90 degrees others make the same turn.
  Vec3 angles_deg_ = Vec3::Zero();
};

}  // namespace underact::gui
