#include "app/gui/view/axis_gizmo.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/gui/kit/larger_font.h"

namespace underact::gui {
namespace {

constexpr double kArmLength = 32.0, kBall = 9.0, kSmallBall = 5.5, kClick = 10.0;

struct GizmoBall {
  int axis;
  double side;
  QPointF at;  // from the middle
  double near;
};

/// Those farthest from the eye first.
std::array<GizmoBall, 6> gizmoBalls(const OrbitCamera& camera) {
  const Vec3 right_W = camera.right_W(), up_W = camera.up_W(), back_W = camera.back_W();
  std::array<GizmoBall, 6> balls{};
  for (int index = 0; index < 6; ++index) {
    const int axis = index / 2;
    const double side = index % 2 == 0 ? 1.0 : -1.0;
    balls[static_cast<std::size_t>(index)] = {axis, side, kArmLength * side * QPointF(right_W[axis], -up_W[axis]),
                                              side * back_W[axis]};
  }
  std::sort(balls.begin(), balls.end(), [](const GizmoBall& a, const GizmoBall& b) { return a.near < b.near; });
  return balls;
}

}  // namespace

QPointF AxisGizmo::middle(const QSizeF& view) {
  return {kAway + 0.5 * kSide, std::round(view.height() - kAway - 0.5 * kSide)};
}

std::optional<Vec3> AxisGizmo::ballAt(const QPointF& pointer, const QSizeF& view, const OrbitCamera& camera) {
  const std::array<GizmoBall, 6> balls = gizmoBalls(camera);
  const QPointF from_middle = pointer - middle(view);
  for (auto ball = balls.rbegin(); ball != balls.rend(); ++ball) {
    const QPointF off = from_middle - ball->at;
    if (std::hypot(off.x(), off.y()) <= kClick) return Vec3(ball->side * Vec3::Unit(ball->axis));
  }
  return {};
}

void AxisGizmo::paint(QPainter& painter, const OrbitCamera& camera, const Theme& theme, const QFont& font) {
  const std::array<QColor, 3> colours{theme.x_axis, theme.y_axis, theme.z_axis};
  const QPointF centre(0.5 * kSide, 0.5 * kSide);
  QFont bold = larger(font, 0.8);
  bold.setBold(true);
  painter.setFont(bold);
  for (const GizmoBall& ball : gizmoBalls(camera)) {
    const QColor& colour = colours[static_cast<std::size_t>(ball.axis)];
    const QPointF end = centre + ball.at;
    if (ball.side < 0.0) {  // hollow
      painter.setPen(QPen(mixed(theme.background, colour, 0.8), 1.5));
      painter.setBrush(mixed(theme.background, colour, 0.25));
      painter.drawEllipse(end, kSmallBall, kSmallBall);
      continue;
    }
    painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(centre, end);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(end, kBall, kBall);
    painter.setPen(theme.dark ? theme.background : QColor(Qt::white));
    painter.drawText(QRectF(end - QPointF(kBall, kBall + 0.5), QSizeF(2.0 * kBall, 2.0 * kBall)), Qt::AlignCenter,
                     QString(QLatin1Char("xyz"[ball.axis])));
  }
}

}  // namespace underact::gui
