#include "app/gui/view/ghost_arm.h"

#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "core/chain/kinematics.h"

namespace underact::gui {

GhostArm::GhostArm() : data_(vtkSmartPointer<vtkPolyData>::New()), actor_(makeActor(data_, Kind::Body)) {
  actor_->SetVisibility(false);
  actor_->GetProperty()->SetOpacity(kOpacity);
}

void GhostArm::setChain(const chain::Chain& chain, Parts parts) {
  chain_ = chain;
  arm::Model model;
  model.chain = chain;
  const ArmSolids arm = parts == Parts::Chain ? chainSolids(model) : solidsOf(model);
  solids_ = arm.solids;
  std::erase_if(solids_, [](const ArmSolid& solid) { return solid.link == 0; });  // the base is that of the arm
  hide();
}

void GhostArm::present(std::span<const double> q) {
  const std::span<const double> mine = q.first(std::min(q.size(), chain_.joints.size()));
  const bool is_known = std::all_of(mine.begin(), mine.end(), [](double value) { return std::isfinite(value); });
  actor_->SetVisibility(is_known && !solids_.empty());
  if (!is_known) return;
  std::vector<Pose> X_WLinks(chain_.joints.size() + 1, Pose::Identity());
  chain::forward(chain_, mine, std::span<Pose>(X_WLinks).subspan(1));
  data_->ShallowCopy(meshOfArm(solids_, X_WLinks));
  data_->Modified();
}

}  // namespace underact::gui
