#include "app/gui/view/arm_picture.h"

#include <vtkMapper.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/chain/kinematics.h"

namespace underact::gui {
namespace {

constexpr double kFootShare = 0.205;  // of the base, of the reach
constexpr double kArmAmbient = 0.32, kArmDiffuse = 0.75, kArmSpecular = 0.16, kArmShine = 28.0;

/// The parts of a solid's profile that are alike, as rods.
void addRods(std::vector<ShadowRod>& rods, const TurnedForm& form, const Pose& X_WLink) {
  double from_m = 0.0, to_m = 0.0, widest_m = 0.0;
  for (const Ring& ring : form.profile) {
    from_m = std::min(from_m, ring.z);
    to_m = std::max(to_m, ring.z);
    widest_m = std::max(widest_m, ring.radius);
  }
  if (form.profile.empty()) return;
  from_m = form.profile.front().z;
  to_m = form.profile.back().z;
  // A rod has round ends: it begins inside.
  const double inside_m = std::min(0.8 * widest_m, 0.49 * std::abs(to_m - from_m));
  const double sign = to_m > from_m ? 1.0 : -1.0;
  const Pose X_WS = X_WLink * form.X_WS;
  const auto radiusNear = [&](double z_m) {
    double radius_m = 0.0;
    for (const Ring& ring : form.profile) {
      if (std::abs(ring.z - z_m) <= 0.34 * std::abs(to_m - from_m)) radius_m = std::max(radius_m, ring.radius);
    }
    return radius_m;
  };
  rods.push_back({X_WS * Vec3(0.0, 0.0, from_m + sign * inside_m), X_WS * Vec3(0.0, 0.0, to_m - sign * inside_m),
                  radiusNear(from_m), radiusNear(to_m)});
}

void addRods(std::vector<ShadowRod>& rods, const BentForm& form, const Pose& X_WLink) {
  constexpr int kParts = 4;
  const auto at = [&](int part) {
    const double angle_rad = form.turn_rad * part / kParts;
    return Vec3(X_WLink * Vec3(form.p_WC +
                               form.radius_m * (std::cos(angle_rad) * form.from_W + std::sin(angle_rad) * form.to_W)));
  };
  for (int part = 0; part < kParts; ++part) rods.push_back({at(part), at(part + 1), form.rod_m, form.rod_m});
}

void addRods(std::vector<ShadowRod>& rods, const BoxForm& form, const Pose& X_WLink) {
  const Pose X_WS = X_WLink * form.X_WS;
  rods.push_back({X_WS * Vec3(0.0, 0.0, -form.half_m.z()), X_WS * Vec3(0.0, 0.0, form.half_m.z()), form.half_m.x(),
                  form.half_m.x()});
}

/// A mesh is about as a rod along the longest edge of its box.
void addRods(std::vector<ShadowRod>& rods, const MeshForm& form, const Pose& X_WLink) {
  const Pose X_WS = X_WLink * form.X_WS;
  const Vec3 middle = 0.5 * (form.mesh->low + form.mesh->high).cwiseProduct(form.m_per_unit);
  const Vec3 half = 0.5 * (form.mesh->high - form.mesh->low).cwiseProduct(form.m_per_unit).cwiseAbs();
  Eigen::Index axis = 0;
  const double longest_m = half.maxCoeff(&axis), radius_m = 0.5 * (half.sum() - longest_m);
  const Vec3 sign = std::max(0.0, longest_m - radius_m) * Vec3::Unit(axis);
  rods.push_back({X_WS * Vec3(middle - sign), X_WS * Vec3(middle + sign), radius_m, radius_m});
}

bool isSameChain(const chain::Chain& a, const chain::Chain& b) {
  const auto alike = [](const chain::Joint& one, const chain::Joint& other) {
    return one.type == other.type && one.axis_W == other.axis_W && one.p_WJ == other.p_WJ && one.min == other.min &&
           one.max == other.max;
  };
  return a.X_WT_home.matrix() == b.X_WT_home.matrix() &&
         std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end(), alike);
}

bool areSame(const std::vector<arm::LinkSolid>& a, const std::vector<arm::LinkSolid>& b) {
  const auto sizesOf = [](const arm::SolidForm& form) -> Vec3 {
    if (const auto* const mesh = std::get_if<arm::MeshSolid>(&form)) return mesh->m_per_unit;
    if (const auto* const box = std::get_if<arm::BoxSolid>(&form)) return box->size_m;
    if (const auto* const ball = std::get_if<arm::SphereSolid>(&form)) return {ball->radius_m, 0.0, 0.0};
    if (const auto* const rod = std::get_if<arm::CylinderSolid>(&form)) return {rod->radius_m, rod->length_m, 0.0};
    const auto& capsule = std::get<arm::CapsuleSolid>(form);
    return {capsule.radius_m, capsule.length_m, 0.0};
  };
  const auto nameOf = [](const arm::SolidForm& form) {
    const auto* const mesh = std::get_if<arm::MeshSolid>(&form);
    return mesh != nullptr ? mesh->name : std::string();
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const arm::LinkSolid& one, const arm::LinkSolid& other) {
                      return one.link == other.link && one.form.index() == other.form.index() &&
                             one.X_WS.matrix() == other.X_WS.matrix() && sizesOf(one.form) == sizesOf(other.form) &&
                             nameOf(one.form) == nameOf(other.form);
                    });
}

}  // namespace

Finishes armFinishes(const Theme& theme) {
  const auto ink = [&](double share) { return mixed(theme.background, theme.ink, share); };
  // Two materials: the housings' plastic and the links' metal. As far from each other as both are seen on the desk.
  if (theme.dark) return {ink(0.56), ink(0.5), ink(0.9), theme.ink};
  return {ink(0.74), ink(0.9), ink(0.48), theme.ink};
}

ArmPicture::ArmPicture() : outline_actor_(makeActor(outlines_.data(), PieceKind::Line)) {
  setArm(*arm::findModel(arm::kDefaultArm));
}

void ArmPicture::setArm(const arm::Model& model) {
  if (!actors_.empty() && isSameChain(model.chain, chain_) && areSame(model.solids, model_.solids) &&
      model.folder == model_.folder)
    return;  // an edit of the scene: the pose stays
  model_ = model;
  reading_.reset();
  problems_.clear();
  if (countMeshes(model) > 0) {
    reading_ = std::make_unique<Background<ArmMeshes>>([model](WorkState& state) {
      TaskMonitor monitor;
      monitor.cancelled = &state.cancelled;
      return readArmMeshes(model, monitor);
    });
  }
  arm_ = solidsOf(model);
  chain_ = model.chain;
  known_ = false;
  X_WT_ = chain_.X_WT_home;
  X_WLinks_.assign(chain_.joints.size() + 1, Pose::Identity());
  actors_.clear();
  for (std::size_t link = 0; link <= chain_.joints.size(); ++link) {
    actors_.push_back(makeActor(meshOfLink(arm_.solids, link, armFinishes(theme_)), PieceKind::Solid));
    vtkProperty& property = *actors_.back()->GetProperty();
    property.SetAmbient(kArmAmbient);
    property.SetDiffuse(kArmDiffuse);
    property.SetSpecular(kArmSpecular);
    property.SetSpecularPower(kArmShine);
  }
  place();
}

bool ArmPicture::takeRead() {
  std::optional<ArmMeshes> read = reading_ ? reading_->take() : std::nullopt;
  if (!read) return false;
  reading_.reset();
  arm_ = solidsOf(model_, *read);
  problems_ = std::move(read->problems);
  build();
  return true;
}

void ArmPicture::build() {
  for (std::size_t link = 0; link < actors_.size(); ++link) {
    vtkPolyDataMapper::SafeDownCast(actors_[link]->GetMapper())
        ->SetInputData(meshOfLink(arm_.solids, link, armFinishes(theme_)));
  }
}

void ArmPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  build();
}

void ArmPicture::setLineWidth(double scale) {
  outline_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.25 * scale));
}

void ArmPicture::show(bool arm, bool stylus) {
  show_arm_ = arm;
  show_stylus_ = stylus;
  place();
}

bool ArmPicture::present(std::span<const double> q) {
  const std::span<const double> mine = q.first(std::min(q.size(), chain_.joints.size()));
  if (!std::all_of(mine.begin(), mine.end(), [](double value) { return std::isfinite(value); })) return false;
  X_WT_ = chain::forward(chain_, mine, std::span<Pose>(X_WLinks_).subspan(1));
  known_ = true;
  place();
  return true;
}

std::vector<vtkActor*> ArmPicture::solids() const {
  std::vector<vtkActor*> solids;
  for (const auto& actor : actors_) solids.push_back(actor);
  return solids;
}

void ArmPicture::place() {
  for (std::size_t link = 0; link < actors_.size(); ++link) {
    actors_[link]->SetVisibility(known_ && (link + 1 < actors_.size() ? show_arm_ : show_stylus_));
    Eigen::Matrix4d X = X_WLinks_[link].matrix();
    X.block<3, 1>(0, 3) *= kMillimetrePerMetre;
    gui::place(*actors_[link], X);
  }
}

void ArmPicture::update(const OrbitCamera& camera) {
  outlines_.clear();
  if (known_) {
    EdgeShade shade{kArmAmbient, kArmDiffuse, {}, kLightStrengths};
    for (std::size_t light = 0; light < kLights.size(); ++light) {
      const Vec3 sign = kLights[light].normalized();
      shade.lights_W[light] = sign.x() * camera.right_W() + sign.y() * camera.up_W() + sign.z() * camera.back_W();
    }
    const Finishes finishes = armFinishes(theme_);
    for (const ArmSolid& solid : arm_.solids) {
      if (actors_[solid.link]->GetVisibility() == 0) continue;
      addOutline(outlines_, solid, X_WLinks_[solid.link], camera.eye_mm(), shade,
                 finishes[static_cast<std::size_t>(solid.finish)]);
    }
  }
  outlines_.done();
}

std::array<Vec3, 2> ArmPicture::stylus_W() const {
  return {X_WT_.translation(), X_WLinks_.back() * arm_.p_WEnd};
}

std::vector<Vec3> ArmPicture::extent_mm() const {
  std::vector<Vec3> points;
  if (!known_) return points;
  const auto add = [&](const Vec3& p_W, double around_m) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-around_m, around_m})
        points.push_back(kMillimetrePerMetre * (p_W + side * Vec3::Unit(axis)));
    }
  };
  for (const Vec3& p_W : stylus_W()) points.push_back(kMillimetrePerMetre * p_W);
  if (!show_arm_) return points;
  for (std::size_t index = 0; index < arm_.axes.size(); ++index) {
    add(X_WLinks_[index] * arm_.axes[index].in_W, arm_.axes[index].radius_m);
    add(X_WLinks_[index + 1] * arm_.axes[index].out_W, arm_.axes[index].radius_m);
  }
  add(arm_.stand.p_WG, kFootShare * arm_.stand.size * kOmniReach_m);
  return points;
}

std::vector<ShadowRod> ArmPicture::shadowRods() const {
  return rodsFrom(0);
}

std::vector<ShadowRod> ArmPicture::gimbalRods() const {
  constexpr std::size_t kArm = 3;  // links that carry it
  return rodsFrom(std::max(kArm + 1, chain_.joints.size() - std::min<std::size_t>(2, chain_.joints.size())));
}

std::vector<ShadowRod> ArmPicture::rodsFrom(std::size_t first_link) const {
  std::vector<ShadowRod> rods;
  if (!known_) return rods;
  for (const ArmSolid& solid : arm_.solids) {
    if (solid.link < first_link) continue;
    const bool shown = solid.link + 1 < actors_.size() ? show_arm_ : show_stylus_;
    if (shown) std::visit([&](const auto& form) { addRods(rods, form, X_WLinks_[solid.link]); }, solid.form);
  }
  return rods;
}

}  // namespace underact::gui
