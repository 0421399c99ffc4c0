#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "app/gui/view/axis_gizmo.h"
#include "app/gui/view/scene_view_impl.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kGrab_px = 28.0, kGrabBody_px = 20.0, kGrabGimbal_px = 6.0;  // beside tip, body and gimbal
constexpr double kStep_m = 0.002, kBigStep_m = 0.010, kWheelDepth_m = 0.005, kTurn_rad = 5.0 * kRadPerDegree;
constexpr double kOrbit_px = 24.0;  // of a drag, equivalent to one arrow key

/// right, up, away of an arrow or page key; zero: another key.
Vec3 offsetOf(int key) {
  switch (key) {
    case Qt::Key_Right:
      return {1, 0, 0};
    case Qt::Key_Left:
      return {-1, 0, 0};
    case Qt::Key_Up:
      return {0, 1, 0};
    case Qt::Key_Down:
      return {0, -1, 0};
    case Qt::Key_PageUp:
      return {0, 0, 1};
    case Qt::Key_PageDown:
      return {0, 0, -1};
    default:
      return Vec3::Zero();
  }
}

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF offset = b - a;
  const double length2 = QPointF::dotProduct(offset, offset);
  const double share = length2 > 0.0 ? std::clamp(QPointF::dotProduct(p - a, offset) / length2, 0.0, 1.0) : 0.0;
  const QPointF off = p - a - share * offset;
  return std::hypot(off.x(), off.y());
}

}  // namespace

void SceneView::Impl::cameraByHand(const OrbitCamera& wanted) {
  movement.stop();
  camera = wanted;
  camera_is_mine = false;
  surface->update();
}

bool SceneView::Impl::overStylus(const QPointF& pointer) const {
  if (!hand_available || !hand.known()) return false;
  const auto [tip_W, end_W] = hand.arm().stylus_W();
  const QPointF tip = view->screenOf(tip_W), end = view->screenOf(end_W);
  const QPointF off = pointer - tip;
  if (std::hypot(off.x(), off.y()) <= kGrab_px || distanceToSegment(pointer, tip, end) <= kGrabBody_px) return true;
  const double px_per_m =
      kMillimetrePerMetre / pixelLength_mm(size(), project(camera, size(), kMillimetrePerMetre * tip_W).depth_mm);
  const std::vector<ShadowRod> gimbal = hand.arm().gimbalRods();
  return std::any_of(gimbal.begin(), gimbal.end(), [&](const ShadowRod& rod) {
    return distanceToSegment(pointer, view->screenOf(rod.from_W), view->screenOf(rod.to_W)) <=
           std::max(rod.from_radius_m, rod.to_radius_m) * px_per_m + kGrabGimbal_px;
  });
}

std::optional<Vec3> SceneView::Impl::gizmoAt(const QPointF& pointer) const {
  return has_words ? AxisGizmo::ballAt(pointer, size(), camera) : std::nullopt;
}

void SceneView::Impl::showPointer(const QPointF& pointer) {
  Qt::CursorShape shape = Qt::ArrowCursor;
  if (drag == Drag::Hand) {
    shape = Qt::ClosedHandCursor;
  } else if (drag == Drag::None && gizmoAt(pointer)) {
    shape = Qt::PointingHandCursor;
  } else if (drag == Drag::None && overStylus(pointer)) {
    shape = Qt::OpenHandCursor;
  }
  if (view->cursor().shape() != shape) view->setCursor(shape);
}

void SceneView::Impl::take() {
  if (held_by_mouse || !held_by_keys.isEmpty()) return;
  emit view->handGrabbed();
  if (grip.take(hand.X_WT())) emit view->handMoved(grip.setpoint());
}

void SceneView::Impl::releaseKeys() {
  if (held_by_keys.isEmpty()) return;
  held_by_keys.clear();
  if (!held_by_mouse) emit view->handReleased(false);
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  Impl& my = *impl_;
  my.last = my.pressed = event->position();
  if (my.drag != Drag::None) return;  // one button at a time
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  if (event->button() == Qt::LeftButton && !shift) {
    if (const std::optional<Vec3> from_W = my.gizmoAt(event->position())) {
      // Again on the axis that points at the eye: from the other side.
      const bool is_there = from_W->dot(my.wanted().back_W()) > 0.9999;
      return lookFrom(is_there ? Vec3(-*from_W) : *from_W);
    }
  }
  if (event->button() == Qt::LeftButton && !shift && my.overStylus(event->position())) {
    my.take();
    my.held_by_mouse = true;
    my.drag = Drag::Hand;
  } else if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && shift)) {
    my.drag = Drag::Pan;
  } else if (event->button() == Qt::LeftButton) {
    my.drag = Drag::Orbit;
  } else if (event->button() == Qt::RightButton) {
    my.drag = Drag::Zoom;
  }
  my.showPointer(event->position());
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  Impl& my = *impl_;
  const QPointF offset = event->position() - my.last;
  my.last = event->position();
  my.showPointer(event->position());
  if (offset.isNull()) return;
  switch (my.drag) {
    case Drag::None:
      return;
    case Drag::Orbit:
      return my.cameraByHand(orbited(my.camera, my.size(), offset));
    case Drag::Pan:
      return my.cameraByHand(panned(my.camera, my.size(), offset));
    case Drag::Zoom:
      return my.cameraByHand(zoomed(my.camera, my.size(), my.pressed, std::exp(0.006 * offset.y())));
    case Drag::Hand:
      if (event->modifiers().testFlag(Qt::ControlModifier)) {
        my.grip.turn(my.camera, my.hand.X_WT().linear(), offset);
      } else {
        my.grip.drag(my.camera, my.size(), my.hand.X_WT().translation(), offset);
      }
      emit handMoved(my.grip.setpoint());
  }
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  Impl& my = *impl_;
  if (event->buttons() != Qt::NoButton) return;
  const bool held = my.held_by_mouse;
  my.held_by_mouse = false;
  my.drag = Drag::None;
  my.showPointer(event->position());
  if (held && my.held_by_keys.isEmpty()) emit handReleased(true);
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  const bool is_taken = impl_->overStylus(event->position()) || impl_->gizmoAt(event->position());
  if (event->button() != Qt::LeftButton || is_taken) return mousePressEvent(event);
  moveCamera(Camera::Fit);
}

void SceneView::wheelEvent(QWheelEvent* event) {
  Impl& my = *impl_;
  const double notches = event->angleDelta().y() / 120.0;
  event->accept();
  if (notches == 0.0) return;
  if (my.drag == Drag::Hand) {
    my.grip.deepen(my.camera, my.hand.X_WT().translation(), kWheelDepth_m * notches);
    emit handMoved(my.grip.setpoint());
  } else {
    my.cameraByHand(zoomed(my.camera, my.size(), event->position(), std::pow(0.87, notches)));
  }
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  Impl& my = *impl_;
  const Vec3 offset = offsetOf(event->key());
  const Qt::KeyboardModifiers modifiers = event->modifiers() & ~Qt::KeypadModifier;
  if (offset.isZero()) return QWidget::keyPressEvent(event);
  if (!my.hand_available || !my.hand.known() || modifiers.testFlag(Qt::AltModifier)) {
    if (offset.z() != 0.0) {
      my.cameraByHand(zoomed(my.camera, my.size(), QPointF(0.5 * width(), 0.5 * height()), std::pow(0.87, offset.z())));
    } else {
      my.cameraByHand(orbited(my.camera, my.size(), kOrbit_px * QPointF(offset.x(), -offset.y())));
    }
    return;
  }
  my.take();
  my.held_by_keys.insert(event->key());
  if (modifiers.testFlag(Qt::ControlModifier)) {
    my.grip.turnStep(my.camera, my.hand.X_WT().linear(), offset, kTurn_rad);
  } else {
    my.grip.step(my.camera, my.hand.X_WT().translation(), offset,
                 modifiers.testFlag(Qt::ShiftModifier) ? kBigStep_m : kStep_m);
  }
  emit handMoved(my.grip.setpoint());
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
  if (event->isAutoRepeat() || !impl_->held_by_keys.remove(event->key())) return QWidget::keyReleaseEvent(event);
  if (impl_->held_by_keys.isEmpty() && !impl_->held_by_mouse) emit handReleased(false);
}

void SceneView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  impl_->surface->update();
}

void SceneView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  impl_->releaseKeys();
  impl_->surface->update();
}

void SceneView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  if (impl_->drag == Drag::None) unsetCursor();
}

}  // namespace underact::gui
