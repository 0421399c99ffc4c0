#include "app/gui/view/desk_picture.h"

#include <vtkProperty.h>

#include <QCoreApplication>
#include <utility>

#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kRim_mm = 20.0;  // of the sheet about the marks
constexpr double kDeskRing_mm = 4.0, kCross_mm = 6.0, kDeskLabelAway_mm = 10.0;

}  // namespace

DeskPicture::DeskPicture() : actor_(makeActor(lines_.data(), PieceKind::Line)) {}

void DeskPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  build();
}

void DeskPicture::setLineWidth(double scale) {
  actor_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * scale));
}

void DeskPicture::setDesk(const std::optional<Desk>& desk) {
  desk_ = desk;
  build();
}

void DeskPicture::show(bool shown) {
  if (std::exchange(shown_, shown) != shown) build();
}

void DeskPicture::build() {
  lines_.clear();
  labels_.clear();
  corners_mm_.clear();
  if (marks() > 0) {
    Pose X_WD_mm = desk_->X_WD;
    X_WD_mm.translation() *= kMillimetrePerMetre;
    const Vec3 right = X_WD_mm.linear().col(0), up = X_WD_mm.linear().col(1), back = X_WD_mm.linear().col(2);
    const QColor ink = mixed(theme_.quiet, theme_.ink, 0.6);
    Vec3 min_mm = Vec3::Constant(kInfinity), max_mm = -min_mm;
    for (std::size_t at = 0; at < desk_->points_D.size(); ++at) {
      const Vec3 p_DM_mm = kMillimetrePerMetre * desk_->points_D[at], p_mm = X_WD_mm * p_DM_mm;
      min_mm = min_mm.cwiseMin(p_DM_mm);
      max_mm = max_mm.cwiseMax(p_DM_mm);
      lines_.circle(p_mm, right, back, kDeskRing_mm, ink);
      for (const Vec3& direction : {right, back})
        lines_.segment(p_mm - kCross_mm * direction, p_mm + kCross_mm * direction, ink);
      labels_.push_back({QString::number(at + 1), p_mm + kDeskLabelAway_mm * (right + back).normalized(), ink, true});
    }
    const Vec3 rim_mm(kRim_mm, 0.0, kRim_mm);
    min_mm -= rim_mm;
    max_mm += rim_mm;
    for (const auto& [x, z] : {std::pair{min_mm.x(), min_mm.z()},
                               {max_mm.x(), min_mm.z()},
                               {max_mm.x(), max_mm.z()},
                               {min_mm.x(), max_mm.z()}})
      corners_mm_.push_back(X_WD_mm * Vec3(x, min_mm.y(), z));
    lines_.chain(corners_mm_, theme_.quiet, true);
    labels_.push_back({QCoreApplication::translate("SceneView", "desk"), corners_mm_[3] + 6.0 * up, ink, false});
  }
  lines_.done();
}

}  // namespace underact::gui
