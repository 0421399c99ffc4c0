#pragma once
#include <QFont>
#include <QPointF>
#include <QSizeF>
#include <optional>

#include "app/gui/kit/theme.h"
#include "app/gui/view/orbit_camera.h"

class QPainter;

namespace underact::gui {

/// The small axes in the corner of the view, with a ball at each end: a click looks from there.
struct AxisGizmo {
  static constexpr double kSide = 92.0, kAway = 12.0;  // logical pixels: its square, and its distance from the corner

  /// The middle of its square at the lower left of a view of that size.
  static QPointF middle(const QSizeF& view);
  /// The direction in W of the ball under the pointer, the nearest one of those that overlap.
  static std::optional<Vec3> ballAt(const QPointF& pointer, const QSizeF& view, const OrbitCamera& camera);
  /// Into a square of kSide.
  static void paint(QPainter& painter, const OrbitCamera& camera, const Theme& theme, const QFont& font);
};

}  // namespace underact::gui
