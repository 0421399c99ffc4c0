#pragma once
#include <QWidget>
#include <array>
#include <vector>

#include "core/lab/arm_model.h"
#include "core/scene/description.h"

class QComboBox;
class QFormLayout;

namespace underact::gui {

class ValueRow;

/// The inputs of a response: the constraint, the control law with its gains, mass and damping.
class StepRows : public QWidget {
  Q_OBJECT
 public:
  enum Quantity { kKp, kKd, kKi, kMass, kDamping, kQuantities };

  explicit StepRows(QWidget* parent = nullptr);
  void list(const std::vector<scene::Constraint>& constraints, std::size_t chosen);
  /// own: the values marked on the sliders, which are the scene's gains and the arm's mass and damping.
  void present(const lab::HeldMass& held, scene::LawType law, const lab::HeldMass& own);

  /// In SI.
  static double& valueOf(lab::HeldMass& held, int quantity);
  /// One unit of the row, such as N/mm, in SI.
  static double unitOf(int quantity);
  static int quantityOf(const QString& key);  // "kp", "mass"; -1: unknown key

 signals:
  void constraintChosen(int index);
  void lawChosen(underact::scene::LawType law);
  void quantityChanged(int quantity, double value);  // in the row's unit

 private:
  QFormLayout* choices_;
  QComboBox *constraint_, *law_;
  std::array<ValueRow*, kQuantities> rows_{};
};

}  // namespace underact::gui
