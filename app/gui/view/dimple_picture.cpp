#include "app/gui/view/dimple_picture.h"

#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/scene/fields.h"

namespace underact::gui {
namespace {

constexpr int kDimpleRings = 10, kDimpleSectors = 36;
constexpr double kDimpleOpacity = 0.7;
constexpr double kNoDepth_mm = 0.01;  // shallower: the direction of the surface is not known

/// How deep a dimple is at that share of its radius: 1 in the middle, 0 at the rim, and level at both.
double depthAt(double share) {
  const double t = 1.0 - std::clamp(share, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

DimplePicture::DimplePicture()
    : actor_(makeActor(faces_.data(), PieceKind::Line)),  // unlit, and without depth
      ring_actor_(makeActor(rings_.data(), PieceKind::Line)) {}

void DimplePicture::setScene(const scene::Description& scene) {
  is_surface_.clear();
  for (const scene::Constraint& constraint : scene.constraints)
    is_surface_.push_back(hasSides(constraint.shape) && !std::holds_alternative<scene::Mesh>(constraint.shape));
}

void DimplePicture::setLineWidth(double scale) {
  ring_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.25 * scale));
}

void DimplePicture::present(const tick::TickReport& report, const Vec3& p_WT, double force_share, double size) {
  dimples_ = 0;
  faces_.clear();
  rings_.clear();
  if (shown_ && force_share > kMinShare && p_WT.allFinite()) {
    const double radius_mm = size * (kMin_mm + (kMax_mm - kMin_mm) * std::sqrt(std::min(1.0, force_share)));
    for (std::size_t index = 0; index < std::min(report.held.size(), is_surface_.size()); ++index) {
      const tick::ConstraintReport& held = report.held[index];
      if (!is_surface_[index] || !held.acts || held.status != target::Status::Unique || !held.p_WP.allFinite())
        continue;
      add(kMillimetrePerMetre * held.p_WP, kMillimetrePerMetre * p_WT, radius_mm);
    }
  }
  faces_.done();
  rings_.done();
}

void DimplePicture::add(const Vec3& target_mm, const Vec3& tip_mm, double radius_mm) {
  const Vec3 down_mm = tip_mm - target_mm;
  if (!(down_mm.norm() > kNoDepth_mm)) return;
  ++dimples_;
  const Vec3 u = down_mm.unitOrthogonal(), v = down_mm.normalized().cross(u);
  const auto at = [&](double share, double angle_rad) {
    return Vec3(target_mm + depthAt(share) * down_mm +
                share * radius_mm * (std::cos(angle_rad) * u + std::sin(angle_rad) * v));
  };
  std::vector<vtkIdType> corners;
  for (int ring = 0; ring <= kDimpleRings; ++ring) {
    const double share = static_cast<double>(ring) / kDimpleRings;
    QColor colour = mixed(theme_.force, theme_.constraint, share);
    colour.setAlpha(static_cast<int>(std::lround(255.0 * kDimpleOpacity * depthAt(share))));
    for (int sector = 0; sector <= kDimpleSectors; ++sector)
      corners.push_back(faces_.corner(at(share, 2.0 * kPi * sector / kDimpleSectors), colour));
  }
  for (int ring = 0; ring < kDimpleRings; ++ring) {
    for (int sector = 0; sector < kDimpleSectors; ++sector) {
      const auto corner = static_cast<std::size_t>(ring * (kDimpleSectors + 1) + sector);
      const std::size_t next = corner + kDimpleSectors + 1;
      faces_.face(std::array{corners[corner], corners[corner + 1], corners[next + 1], corners[next]});
    }
  }
  for (const double share : {0.34, 0.67, 1.0}) {
    std::array<Vec3, kDimpleSectors> ring;
    for (int sector = 0; sector < kDimpleSectors; ++sector)
      ring[static_cast<std::size_t>(sector)] = at(share, 2.0 * kPi * sector / kDimpleSectors);
    rings_.chain(ring, faint(theme_.constraint, 1.0 - 0.45 * share), true);
  }
}

}  // namespace underact::gui
