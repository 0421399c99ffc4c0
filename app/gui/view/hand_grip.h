#pragma once
#include <QPointF>
#include <QSizeF>

#include "app/gui/view/orbit_camera.h"
#include "core/sim/hand.h"

namespace underact::gui {

/// The commanded position of the hand, and how mouse and keys move it: relative to the last command, not to the tip. In
/// contact the tip lags behind, and a hand that followed it would yield.
class HandGrip {
 public:
  /// The hand is elsewhere: a script moved it, or the arm was changed.
  void set(const sim::HandSetpoint& setpoint);
  void reset() { known_ = false; }
  /// Starts a grip: at the last command if the hand still holds the stylus, otherwise where the stylus is. Whether it
  /// begins to hold.
  bool take(const Pose& X_WT);
  /// Whether the hand holds its position while it only turns the stylus, and when it is released; at first it does not.
  void setKeepsHolding(bool on) { keeps_holding_ = on; }
  const sim::HandSetpoint& setpoint() const { return setpoint_; }

  /// In the plane parallel to the screen through the tip; way in pixels.
  void drag(const OrbitCamera& camera, const QSizeF& size, const Vec3& p_WT, const QPointF& offset);
  /// Away from the eye, m.
  void deepen(const OrbitCamera& camera, const Vec3& p_WT, double travel_m);
  /// About the axes of the screen; way in pixels, one degree for two. R_WT: of the stylus, if no command has rotated it
  /// yet. A grip that has not moved the stylus turns it in loose fingers: the scene moves the tip.
  void turn(const OrbitCamera& camera, const Mat3& R_WT, const QPointF& offset);

  /// Steps along the axes of W nearest to those of the screen: right, up, away, each -1, 0 or 1.
  void step(const OrbitCamera& camera, const Vec3& p_WT, const Vec3& right_up_away, double length_m);
  void turnStep(const OrbitCamera& camera, const Mat3& R_WT, const Vec3& right_up_away, double angle_rad);

 private:
  void keepInside();
  void hold(const Vec3& p_WT);
  void beginTurn(const Mat3& R_WT);
  void turnAbout(const Vec3& axis_W, double angle_rad);
  sim::HandSetpoint setpoint_;
  bool known_ = false;
  bool keeps_holding_ = false;
  bool moved_ = false;  // by this grip
};

/// The axes of W nearest to the screen's right, up and away from the eye, as columns: signed, each used once.
Mat3 nearestAxes(const OrbitCamera& camera);

}  // namespace underact::gui
