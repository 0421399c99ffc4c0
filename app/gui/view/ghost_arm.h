#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <span>
#include <vector>

#include "app/gui/view/arm_solids.h"
#include "app/gui/view/solid_mesh.h"

namespace underact::gui {

/// A chain as translucent solids of one colour: a virtual robot, or the arm in another configuration. One surface, of
/// which only the part nearest to the eye is drawn, so that links do not show through each other.
class GhostArm {
 public:
  static constexpr double kOpacity = 0.28;
  enum class Parts { Chain, WithStylus };

  GhostArm();
  void setChain(const chain::Chain& chain, Parts parts);
  void setColour(const QColor& colour) { gui::setColour(*actor_, colour); }
  /// q: rad or m, one for each joint. Not finite: hidden.
  void present(std::span<const double> q);
  void hide() { actor_->SetVisibility(false); }
  bool isShown() const { return actor_->GetVisibility() != 0; }
  vtkActor* actor() const { return actor_; }

 private:
  chain::Chain chain_;
  std::vector<ArmSolid> solids_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> actor_;
};

}  // namespace underact::gui
