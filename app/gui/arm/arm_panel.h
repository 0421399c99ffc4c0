#pragma once
#include <vector>

#include "app/gui/feature/panel.h"
#include "core/arm/model.h"
#include "core/base/result.h"

class QLabel;
class QVBoxLayout;

namespace underact::gui {

class Readout;

/// Which arm the scene is for, and its state: tip, joints, ramp of the force, fault.
class ArmPanel : public Panel {
  Q_OBJECT
 public:
  explicit ArmPanel(QWidget* parent);
  /// Above the state.
  void addAbove(QWidget* widget);
  /// Which joints there are, and which of them slide. Without: the Omni's.
  void setArm(const arm::Model& model);
  /// Meshes of the arm's file that are not drawn; empty: none. true: others than before, and some.
  bool showNotDrawn(const Problems& problems);
  void present(const servo::Snapshot& snapshot) override;

 private:
  QVBoxLayout* column_;
  Readout* readout_;
  QLabel* not_drawn_;
  std::vector<bool> slides_ = std::vector<bool>(6, false);
  int tip_, first_joints_, last_joints_, level_, fault_;
};

}  // namespace underact::gui
