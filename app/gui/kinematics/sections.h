#pragma once
#include <array>
#include <optional>

#include "app/gui/kit/section.h"
#include "app/gui/kit/theme.h"
#include "app/gui/model/kinematics_now.h"
#include "core/arm/model.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTableWidget;

namespace underact::gui {

class DistanceBar;
class JointRow;
class NumberTable;

/// The joint angles, with sliders that move the simulated arm.
class JointsSection : public Section {
  Q_OBJECT
 public:
  explicit JointsSection(QWidget* parent = nullptr);
  void setArm(const arm::Preset& preset, const arm::Model& model);
  /// refusal: a sentence; empty: the sliders move the arm.
  void setMovable(const QString& refusal);
  /// Why an angle is not as typed; empty: it is.
  void setRemark(const QString& remark);
  void present(const KinematicsNow& now);
 signals:
  void asked(int joint, double angle_deg);
  void stepped(int joint, double by_deg);

 private:
  std::array<JointRow*, arm::kMaxJoints> rows_{};
  std::array<double, arm::kMaxJoints> per_unit_{};  // rad in a degree, m in a mm
  QString refusal_;
  QLabel* note_;
};

/// The distance to each singularity.
class SingularitiesSection : public Section {
  Q_OBJECT
 public:
  explicit SingularitiesSection(QWidget* parent = nullptr);
  void setReach(double reach_m);
  void setTheme(const Theme& theme);
  void present(const KinematicsNow& now);

 private:
  DistanceBar *shoulder_, *elbow_, *wrist_;
};

/// The inverse solutions for the pose of the stylus; one can be selected. Of an arm that solvesInTick() by their
/// branches, which are always eight; of any other as a list of joint values, as long as there are solutions.
class SolutionsSection : public Section {
  Q_OBJECT
 public:
  explicit SolutionsSection(QWidget* parent = nullptr);
  void setArm(const arm::Model& model, bool is_named);
  void present(const KinematicsNow& now);
  /// number: 1 to most(); 0: none.
  void choose(int number);
  int chosen() const;
  /// The largest number that there is now.
  int max() const { return rows_; }
  /// Whether the sentence with the number of solutions is hidden: a lesson asks for it.
  void hideCounts(bool on);
  /// The one of that number now, or null.
  const NumberedSolution* find(int number) const { return solutions_.find(number); }
  /// Why the arm does not move to the chosen one; empty: it does.
  void setMovable(const QString& refusal);
 signals:
  void wanted(int number);  // also the same one again; 0: none
  void moveAsked(int number);

 private:
  void buildTable();
  void showRows(int rows);
  int limitsWidth() const;
  void showChosen();
  bool isArm(const NumberedSolution& solution) const;
  QString valuesText(const NumberedSolution& solution, int decimals, bool with_units) const;

  arm::Model model_;
  bool is_named_ = true;
  int rows_ = -1;
  QLabel *status_, *angles_;
  QTableWidget* table_;
  QPushButton *again_, *none_, *move_;
  QLabel* why_not_;
  NumberedSolutions solutions_;
  arm::JointAngles q_rad_{};
};

/// The DH table with the current angles, and the same configuration in the device's own angles.
class DhSection : public Section {
  Q_OBJECT
 public:
  explicit DhSection(QWidget* parent = nullptr);
  void setArm(const arm::Model& model);
  void present(const KinematicsNow& now, const arm::Model& model);

 private:
  NumberTable* table_;
};
class AnglesSection : public Section {
  Q_OBJECT
 public:
  explicit AnglesSection(QWidget* parent = nullptr);
  void present(const KinematicsNow& now);

 private:
  NumberTable* table_;
};

/// The Jacobian and the measures derived from it.
class JacobianSection : public Section {
  Q_OBJECT
 public:
  explicit JacobianSection(QWidget* parent = nullptr);
  void setArm(const arm::Preset& preset, const arm::Model& model);
  void present(const KinematicsNow& now);

 private:
  QCheckBox* only_position_;
  QStackedWidget* tables_;
  NumberTable *whole_, *position_, *figures_;
};

}  // namespace underact::gui
