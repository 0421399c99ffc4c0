#include "app/gui/view/drawing.h"

#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/gui/view/hand_picture.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kLabelGap_mm = 4.0;  // of a label
constexpr double kRing_mm = 5.0, kHalfAxis_mm = 9.0;
constexpr int kSides = 4;  // of a stylus: the lines along it

}  // namespace

DrawingPicture::DrawingPicture()
    : actor_(makeActor(lines_.data(), PieceKind::Mark)), lit_actor_(makeActor(lit_.data(), PieceKind::Mark)) {}

void DrawingPicture::setLineWidth(double scale) {
  actor_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * scale));
  lit_actor_->GetProperty()->SetLineWidth(static_cast<float>(4.0 * scale));
}

void DrawingPicture::draw(const QString& owner, const Drawing& drawing) {
  if (drawing.isEmpty()) {
    drawings_.remove(owner);
  } else {
    drawings_[owner] = drawing;
  }
  build();
}

void DrawingPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  build();
}

std::size_t DrawingPicture::framesDrawn() const {
  std::size_t count = 0;
  for (const Drawing& drawing : drawings_) count += drawing.frames.size();
  return count;
}

std::size_t DrawingPicture::targetsDrawn() const {
  std::size_t count = 0;
  for (const Drawing& drawing : drawings_) count += drawing.targets.size();
  return count;
}

void DrawingPicture::build() {
  lines_.clear();
  lit_.clear();
  labels_.clear();
  for (const Drawing& drawing : drawings_) {
    for (const DrawnLink& link : drawing.links) add(link);
    for (const DrawnJoint& joint : drawing.joints) add(joint);
    for (const DrawnFrame& frame : drawing.frames) add(frame);
    for (const DrawnStylus& stylus : drawing.styluses) add(stylus);
    for (const DrawnWords& words : drawing.words) add(words);
    for (const DrawnMeasure& measure : drawing.measures) add(measure);
    for (const DrawnTarget& target : drawing.targets) add(target);
  }
  lines_.done();
  lit_.done();
}

void DrawingPicture::add(const DrawnFrame& frame) {
  if (!frame.X_WF.matrix().allFinite()) return;
  const std::array<QColor, 3> colours{theme_.x_axis, theme_.y_axis, theme_.z_axis};
  const Vec3 origin_mm = kMillimetrePerMetre * frame.X_WF.translation();
  const double length_mm = kMillimetrePerMetre * frame.axis_m;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec3 direction = frame.X_WF.linear().col(static_cast<Eigen::Index>(axis));
    lines_.segment(origin_mm, origin_mm + length_mm * direction, colours[axis]);
    if (frame.has_letters)
      labels_.push_back(
          {QString(QChar(u"xyz"[axis])), origin_mm + (length_mm + kLabelGap_mm) * direction, colours[axis], false});
  }
  if (!frame.has_letters) {
    labels_.push_back(
        {frame.name, origin_mm + (length_mm + kLabelGap_mm) * frame.X_WF.linear().col(2), theme_.ink, true});
    return;
  }
  const Vec3 away = -(frame.X_WF.linear() * Vec3::Ones()).normalized();
  labels_.push_back({frame.name, origin_mm + 2.0 * kLabelGap_mm * away, theme_.ink, true});
}

void DrawingPicture::add(const DrawnLink& link) {
  if (!link.from_W.allFinite() || !link.to_W.allFinite()) return;
  const Vec3 from_mm = kMillimetrePerMetre * link.from_W, travel_mm = kMillimetrePerMetre * (link.to_W - link.from_W);
  const QColor colour = mixed(theme_.background, theme_.virtual_robot, link.strength);
  const int pieces = link.dashed ? std::max(1, static_cast<int>(travel_mm.norm() / 8.0)) : 1;
  for (int piece = 0; piece < pieces; ++piece) {
    const double from = static_cast<double>(piece) / pieces, to = from + (link.dashed ? 0.5 : 1.0) / pieces;
    lines_.segment(from_mm + from * travel_mm, from_mm + to * travel_mm, colour);
  }
}

void DrawingPicture::add(const DrawnJoint& joint) {
  if (!joint.p_W.allFinite() || !joint.axis_W.allFinite()) return;
  const Vec3 at_mm = kMillimetrePerMetre * joint.p_W, u = joint.axis_W.unitOrthogonal(), v = joint.axis_W.cross(u);
  const Vec3 half_mm = kHalfAxis_mm * joint.axis_W;
  lines_.segment(at_mm - half_mm, at_mm + half_mm, mixed(theme_.background, theme_.virtual_robot, 0.7));
  if (joint.type == chain::JointType::Revolute) {
    lines_.circle(at_mm, u, v, kRing_mm, theme_.virtual_robot);
  } else {
    const std::array<Vec3, 4> corners{at_mm + kRing_mm * u, at_mm + kRing_mm * v, at_mm - kRing_mm * u,
                                      at_mm - kRing_mm * v};
    lines_.chain(corners, theme_.virtual_robot, true);
  }
}

void DrawingPicture::add(const DrawnStylus& stylus) {
  if (!stylus.p_W.allFinite() || !stylus.axis_W.allFinite() || stylus.axis_W.isZero()) return;
  const Vec3 tip_mm = kMillimetrePerMetre * stylus.p_W, u = stylus.axis_W.unitOrthogonal(), v = stylus.axis_W.cross(u);
  const Vec3 taper_mm = tip_mm + HandPicture::kTaper_mm * stylus.axis_W;
  const Vec3 end_mm = tip_mm + HandPicture::kEnd_mm * stylus.axis_W;
  for (const Vec3& middle_mm : {taper_mm, end_mm})
    lines_.circle(middle_mm, u, v, HandPicture::kBody_mm, theme_.virtual_robot);
  for (const auto& [one, other] : {std::pair(u, v), {v, stylus.axis_W}, {stylus.axis_W, u}})  // a ball from any side
    lines_.circle(tip_mm, one, other, HandPicture::kTip_mm, theme_.virtual_robot);
  for (int side = 0; side < kSides; ++side) {
    const Vec3 out_mm = HandPicture::kBody_mm * (side < 2 ? 1.0 : -1.0) * (side % 2 == 0 ? u : v);
    const std::array<Vec3, 3> along_mm{tip_mm, taper_mm + out_mm, end_mm + out_mm};
    lines_.chain(along_mm, theme_.virtual_robot, false);
  }
}

void DrawingPicture::add(const DrawnMeasure& measure) {
  if (!measure.p_W.allFinite() || !measure.to_end_W.allFinite() || !std::isfinite(measure.turn_rad)) return;
  const std::array<QColor, 3> colours{theme_.x_axis, theme_.y_axis, theme_.z_axis};
  const QColor& colour = colours[static_cast<std::size_t>(measure.axis)];
  const Vec3 p_mm = kMillimetrePerMetre * measure.p_W;
  if (measure.turn_rad == 0.0) {
    const Vec3 travel_mm = kMillimetrePerMetre * measure.to_end_W;
    lit_.segment(p_mm, p_mm + travel_mm, colour);
    labels_.push_back({measure.text, p_mm + 0.5 * travel_mm, colour, true});
    return;
  }
  const int parts = std::max(2, static_cast<int>(std::abs(measure.turn_rad) / 0.1));
  std::vector<Vec3> arc;
  for (int part = 0; part <= parts; ++part) {
    const Eigen::AngleAxisd turn(measure.turn_rad * part / parts, measure.axis_W);
    arc.push_back(p_mm + kMillimetrePerMetre * (turn * measure.to_end_W));
  }
  lit_.chain(arc, colour, false);
  lines_.segment(p_mm, arc.front(), colour);
  lines_.segment(p_mm, arc.back(), colour);
  labels_.push_back({measure.text, p_mm + 1.3 * (arc[arc.size() / 2] - p_mm), colour, true});
}

void DrawingPicture::add(const DrawnTarget& target) {
  if (!target.p_W.allFinite() || !(target.radius_m > 0.0)) return;
  const Vec3 p_mm = kMillimetrePerMetre * target.p_W;
  const double radius_mm = kMillimetrePerMetre * target.radius_m;
  const QColor colour = target.reached ? mixed(theme_.background, theme_.target, 0.4) : theme_.target;
  Lines& lines = target.reached ? lines_ : lit_;
  for (int axis = 0; axis < 3; ++axis)  // a ball from any side
    lines.circle(p_mm, Vec3::Unit(axis), Vec3::Unit((axis + 1) % 3), radius_mm, colour);
  labels_.push_back({target.text, p_mm + Vec3(0.0, radius_mm + kLabelGap_mm, 0.0),
                     target.reached ? colour : readable(colour, theme_), true});
}

void DrawingPicture::add(const DrawnWords& words) {
  if (words.p_W.allFinite()) labels_.push_back({words.text, kMillimetrePerMetre * words.p_W, theme_.ink, true, true});
}

}  // namespace underact::gui
