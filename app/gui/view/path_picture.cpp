#include "app/gui/view/path_picture.h"

#include <vtkProperty.h>

#include <algorithm>
#include <utility>

namespace underact::gui {

PathPicture::PathPicture() : actor_(makeActor(lines_.data(), PieceKind::Line)) {}

void PathPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  build();
}

void PathPicture::setLineWidth(double scale) {
  actor_->GetProperty()->SetLineWidth(static_cast<float>(2.5 * scale));
}

void PathPicture::setForceLimit(double continuous_N) {
  if (continuous_N == limit_N_ || !(continuous_N > 0.0)) return;
  limit_N_ = continuous_N;
  build();
}

void PathPicture::show(bool shown) {
  shown_ = shown;
  build();
}

void PathPicture::setPath(std::vector<PathPoint> path) {
  path_ = std::move(path);
  build();
}

void PathPicture::build() {
  lines_.clear();
  parts_ = 0;
  const QColor nothing = mixed(theme_.background, theme_.ink, 0.5);
  for (std::size_t index = 1; shown_ && index < path_.size(); ++index) {
    const PathPoint &from = path_[index - 1], &to = path_[index];
    if (!from.p_mm.allFinite() || !to.p_mm.allFinite() || from.p_mm == to.p_mm) continue;
    const double share = std::clamp(to.force_N / limit_N_, 0.0, 1.0);
    const QColor colour = share < 0.5 ? mixed(nothing, theme_.force, 2.0 * share)
                                      : mixed(theme_.force, theme_.force_limited, 2.0 * share - 1.0);
    lines_.segment(from.p_mm, to.p_mm, colour);
    ++parts_;
  }
  lines_.done();
}

}  // namespace underact::gui
