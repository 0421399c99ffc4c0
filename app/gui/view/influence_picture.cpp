#include "app/gui/view/influence_picture.h"

#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kInfluenceRing_px = 8.0, kLetter_px = 18.0;  // its radius; how far outwards its letter stands
constexpr std::size_t kRingParts = 24;                        // parts shorter than a pixel come out pale
constexpr double kTangent_mm = 22.0;                          // to each side
constexpr double kPart_rad = 0.05;                            // of an arc's chain
constexpr std::size_t kMaxParts = 80;                         // half a turn and kTie_rad
constexpr double kArcEndShare = 0.45;                         // how opaque the lines to the arc's ends are

/// Points of the arc between two shares of its turn, mm.
std::vector<Vec3> pointsOf(const target::Arc& arc, double from, double to) {
  const double turn_rad = (to - from) * arc.turn_rad;
  const std::size_t parts =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::abs(turn_rad) / kPart_rad) + 1, 1, kMaxParts);
  std::vector<Vec3> points;
  for (std::size_t part = 0; part <= parts; ++part) {
    const double share = from + (to - from) * static_cast<double>(part) / static_cast<double>(parts);
    const Eigen::AngleAxisd turn(share * arc.turn_rad, arc.axis_W);
    points.push_back(kMillimetrePerMetre * (arc.p_WC + turn * (arc.p_WPo - arc.p_WC)));
  }
  return points;
}

}  // namespace

InfluencePicture::InfluencePicture()
    : thin_actor_(makeActor(thin_.data(), PieceKind::Line)),
      bold_actor_(makeActor(bold_.data(), PieceKind::Line)),
      ring_actor_(makeActor(rings_.data(), PieceKind::Mark)) {}

void InfluencePicture::setLineWidth(double scale) {
  thin_actor_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * scale));
  bold_actor_->GetProperty()->SetLineWidth(static_cast<float>(5.0 * scale));
  ring_actor_->GetProperty()->SetLineWidth(static_cast<float>(3.0 * scale));
}

void InfluencePicture::present(const tick::TickReport& report) {
  drawn_.clear();
  for (const tick::ConstraintReport& held : report.held) {
    const bool has_one = held.arc.p_WPo.allFinite() || held.arc.p_WPp.allFinite();
    if (held.acts && held.status == target::Status::Unique && has_one) drawn_.push_back({held.arc, held.p_WP});
  }
}

void InfluencePicture::addArc(const Drawn& drawn) {
  const target::Arc& arc = drawn.arc;
  const Vec3 center_mm = kMillimetrePerMetre * arc.p_WC, target_mm = kMillimetrePerMetre * drawn.p_WP;
  if (arc.p_WPo.allFinite())
    thin_.segment(center_mm, kMillimetrePerMetre * arc.p_WPo, faint(theme_.orientation, kArcEndShare));
  if (arc.p_WPp.allFinite())
    thin_.segment(center_mm, kMillimetrePerMetre * arc.p_WPp, faint(theme_.position, kArcEndShare));
  if (arc.p_WPo.allFinite() && arc.p_WPp.allFinite()) {
    bold_.chain(pointsOf(arc, 0.0, arc.share), theme_.orientation, false);
    thin_.chain(pointsOf(arc, arc.share, 1.0), theme_.position, false);
  }
  const Vec3 along = arc.axis_W.cross(target_mm - center_mm);
  if (along.norm() <= 0.0) return;
  const Vec3 tangent_mm = kTangent_mm * along.normalized();
  thin_.segment(target_mm - tangent_mm, target_mm + tangent_mm, theme_.target);
}

void InfluencePicture::addRing(const Drawn& drawn, const Vec3& p_W, const QColor& colour, const QString& letter,
                               const OrbitCamera& camera, const QSizeF& size) {
  if (!p_W.allFinite()) return;
  const Vec3 p_mm = kMillimetrePerMetre * p_W;
  const double pixel_mm = pixelLength_mm(size, project(camera, size, p_mm).depth_mm);
  std::array<Vec3, kRingParts> ring_mm;
  for (std::size_t part = 0; part < ring_mm.size(); ++part) {
    const double angle_rad = 2.0 * kPi * static_cast<double>(part) / kRingParts;
    ring_mm[part] = p_mm + kInfluenceRing_px * pixel_mm *
                               (std::cos(angle_rad) * camera.right_W() + std::sin(angle_rad) * camera.up_W());
  }
  rings_.chain(ring_mm, colour, true);
  const Vec3 outwards = (p_W - drawn.arc.p_WC).normalized();
  labels_.push_back({letter, p_mm + kLetter_px * pixel_mm * outwards, colour, true});
}

void InfluencePicture::update(const OrbitCamera& camera, const QSizeF& size) {
  labels_.clear();
  for (Lines* lines : {&thin_, &bold_, &rings_}) lines->clear();
  if (shown_) {
    for (const Drawn& drawn : drawn_) {
      addArc(drawn);
      addRing(drawn, drawn.arc.p_WPo, theme_.orientation, QStringLiteral("o"), camera, size);
      addRing(drawn, drawn.arc.p_WPp, theme_.position, QStringLiteral("p"), camera, size);
    }
  }
  for (Lines* lines : {&thin_, &bold_, &rings_}) lines->done();
}

}  // namespace underact::gui
