#pragma once
#include "app/gui/feature/panel.h"

namespace underact::gui {

class Readout;

/// The state of the arm: tip, joints, ramp of the force, fault.
class ArmPanel : public Panel {
  Q_OBJECT
 public:
  explicit ArmPanel(QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;

 private:
  Readout* readout_;
  int tip_, first_joints_, last_joints_, level_, fault_;
};

}  // namespace underact::gui
