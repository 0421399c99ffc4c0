#include "app/gui/view/ghost_arm.h"

#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/chain/kinematics.h"

namespace underact::gui {

constexpr double kBehind_mm = 0.6;  // of the Omni's size: more than a facet is from its circle

GhostArm::GhostArm() : data_(vtkSmartPointer<vtkPolyData>::New()), actor_(makeActor(data_, PieceKind::Body)) {
  actor_->SetVisibility(false);
  setOpacity(kOpacity);
}

void GhostArm::setOpacity(double opacity) {
  actor_->GetProperty()->SetOpacity(opacity);
}

void GhostArm::setOrder(int number) {
  order_ = number;
  setBehind(*actor_, kBehind_mm * size_ * (1 + order_));
}

void GhostArm::setChain(const chain::Chain& chain) {
  arm::Model model;
  model.chain = chain;
  take(chainSolids(model), chain);
}

void GhostArm::setArm(const arm::Model& model) {
  if (!arm::omniGeometry(model)) return take(solidsOf(model), model.chain);
  arm::Model plain;
  plain.chain = model.chain;
  take(solidsOf(plain), model.chain);
}

void GhostArm::take(ArmSolids arm, const chain::Chain& chain) {
  chain_ = chain;
  solids_ = std::move(arm.solids);
  axes_ = std::move(arm.axes);
  size_ = arm.stand.size;
  setOrder(order_);
  std::erase_if(solids_, [](const ArmSolid& solid) { return solid.link == 0; });  // the base is that of the arm
  shown_.clear();
  hide();
}

std::vector<Pose> GhostArm::linksAt(std::span<const double> q) const {
  std::vector<Pose> X_WLinks(chain_.joints.size() + 1, Pose::Identity());
  chain::forward(chain_, q.first(std::min(q.size(), chain_.joints.size())), std::span<Pose>(X_WLinks).subspan(1));
  return X_WLinks;
}

void GhostArm::present(std::span<const double> q) {
  const std::span<const double> mine = q.first(std::min(q.size(), chain_.joints.size()));
  const bool is_known = std::all_of(mine.begin(), mine.end(), [](double value) { return std::isfinite(value); });
  actor_->SetVisibility(is_known && !solids_.empty());
  if (!is_known) return;
  const std::vector<Pose> X_WLinks = linksAt(mine);
  data_->ShallowCopy(meshOfArms(solids_, std::span(&X_WLinks, 1)));
  data_->Modified();
  shown_.clear();
}

void GhostArm::presentAll(const std::vector<arm::JointAngles>& configurations) {
  actor_->SetVisibility(!configurations.empty() && !solids_.empty());
  if (configurations.empty() || configurations == shown_) return;
  std::vector<std::vector<Pose>> X_WLinks;
  for (const arm::JointAngles& q : configurations) X_WLinks.push_back(linksAt(q));
  data_->ShallowCopy(meshOfArms(solids_, X_WLinks));
  data_->Modified();
  shown_ = configurations;
}

std::vector<Vec3> GhostArm::skeleton_mm(std::span<const double> q) const {
  const std::vector<Pose> X_WLinks = linksAt(q);
  std::vector<Vec3> points_mm;
  for (std::size_t joint = 0; joint < axes_.size(); ++joint) {
    points_mm.emplace_back(kMillimetrePerMetre * (X_WLinks[joint] * axes_[joint].in_W));
    points_mm.emplace_back(kMillimetrePerMetre * (X_WLinks[joint + 1] * axes_[joint].out_W));
  }
  points_mm.emplace_back(kMillimetrePerMetre * (X_WLinks.back() * chain_.X_WT_home.translation()));
  return points_mm;
}

}  // namespace underact::gui
