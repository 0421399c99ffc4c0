#pragma once
#include <QMarginsF>
#include <QPointF>
#include <QSizeF>
#include <span>

#include "core/base/types.h"

namespace underact::gui {

/// A camera that orbits a point with y of W up, or y of the desk D if the arm stands rotated on it: no roll, so that
/// "up" on the screen is always up. Lengths in mm, as drawn.
struct OrbitCamera {
  Vec3 focus_mm = Vec3::Zero();
  double distance_mm = 700.0;
  double azimuth_rad = 0.0;      // 0: from the user's side, along -z; positive: from the right
  double elevation_rad = 0.0;    // positive: from above
  Mat3 R_WD = Mat3::Identity();  // the frame that front, right and up are of
  bool parallel = false;         // orthographic: everything has the scale of the focal plane

  static constexpr double kViewAngle_rad = 0.42;  // of the height: small, for little distortion

  bool operator==(const OrbitCamera&) const = default;
  Vec3 right_W() const;
  Vec3 up_W() const;
  Vec3 back_W() const;  // from the focus to the eye
  /// In parallel projection so far away that all lines of sight are parallel to the eye.
  Vec3 eye_mm() const;
};

/// Where a point is drawn, in pixels from the top left; depth: how far in front of the eye, mm (not above 0: behind
/// it); in parallel projection that of the focal plane, which has the scale of all.
struct OnScreen {
  QPointF pixel;
  double depth_mm = 0.0;
};
OnScreen project(const OrbitCamera& camera, const QSizeF& size, const Vec3& p_mm);

/// How long one pixel is at a depth, mm.
double pixelLength_mm(const QSizeF& size, double depth_mm);

/// dx, dy in pixels, as the mouse moved. The full height is half a turn.
OrbitCamera orbited(OrbitCamera camera, const QSizeF& size, const QPointF& offset);
/// Points in the focal plane follow the pointer.
OrbitCamera panned(OrbitCamera camera, const QSizeF& size, const QPointF& offset);
/// factor < 1: nearer. The point under the pointer in the focal plane stays there.
OrbitCamera zoomed(OrbitCamera camera, const QSizeF& size, const QPointF& pointer, double factor);
/// Looks from the direction `from_W` of W; along the vertical with the user's side below.
OrbitCamera lookingFrom(OrbitCamera camera, const Vec3& from_W);
/// Shows all points, with margins (pixels) for text; the direction stays.
OrbitCamera fitted(OrbitCamera camera, const QSizeF& size, std::span<const Vec3> points_mm, const QMarginsF& room);
/// Interpolates from a to b, share 0 to 1; the azimuth takes the shorter way round.
OrbitCamera between(const OrbitCamera& a, const OrbitCamera& b, double share);

}  // namespace underact::gui
