#pragma once
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

#include "app/gui/view/scene_view.h"
#include "core/arm/forward.h"
#include "core/arm/inverse.h"

namespace underact::gui::test {

inline const arm::Preset& preset() {
  return *arm::findPreset(arm::kDefaultArm);
}

inline scene::Description sceneOf(const scene::Shape& shape) {
  scene::Description scene;
  scene::Constraint constraint;
  constraint.name = "one";
  constraint.shape = shape;
  scene.constraints.push_back(constraint);
  return scene;
}

/// A tick as the servo would report it: tip at p_WT, held to p_WP, f_T_W asked and sent through the gate.
inline servo::Snapshot snapshotAt(const Vec3& p_WT, const Vec3& p_WP, const Vec3& f_T_W) {
  servo::Snapshot snapshot;
  snapshot.mode = servo::Mode::Running;
  tick::TickReport& report = snapshot.report;
  report.sample.q_rad = arm::solvePosition(preset().geometry, p_WT).q_rad;
  report.sample.q_rad[4] = 1.6;  // the stylus points at the user
  report.p_WT = p_WT;
  report.held.resize(1);
  report.held[0] = {{}, p_WP, f_T_W, target::Status::Unique, (p_WP - p_WT).norm(), true};
  safety::Limits limits;
  limits.max_force_N = preset().continuous_force_N;
  safety::GateState gate;
  gate.level = 1.0;
  const safety::Gated gated = safety::gate(limits, gate, {f_T_W, true, false, {}}, 0.001);
  report.f_T_W = f_T_W;
  report.force = gated.force;
  report.cut_N = safety::sumOf(gated.cuts);
  return snapshot;
}

/// A view as a person would see it, 800 x 600, from the front.
class Shown {
 public:
  explicit Shown(const scene::Description& scene, Camera camera = Camera::Front) {
    view.setScene(scene);
    view.setHandAvailable(true);
    view.show();
    view.resize(800, 600);  // as high as the screen of some tests, where no desktop adds a frame
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
    moveCamera(camera);
  }
  void moveCamera(Camera camera) {
    view.moveCamera(camera);
    EXPECT_TRUE(QTest::qWaitFor([this] { return !view.moving(); }));
  }
  void send(QEvent::Type type, const QPointF& at, Qt::MouseButton button, Qt::MouseButtons buttons,
            Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QMouseEvent event(type, at, view.mapToGlobal(at), button, buttons, modifiers);
    QCoreApplication::sendEvent(&view, &event);
  }
  void drag(const QPointF& from, const QPointF& to, Qt::MouseButton button = Qt::LeftButton,
            Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    send(QEvent::MouseButtonPress, from, button, button, modifiers);
    send(QEvent::MouseMove, 0.5 * (from + to), Qt::NoButton, button, modifiers);
    send(QEvent::MouseMove, to, Qt::NoButton, button, modifiers);
    send(QEvent::MouseButtonRelease, to, button, Qt::NoButton, modifiers);
  }
  void wheel(const QPointF& at, int notches, Qt::MouseButtons buttons = Qt::NoButton) {
    QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * notches}, buttons, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&view, &event);
  }
  void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
      QKeyEvent event(type, key, modifiers);
      QCoreApplication::sendEvent(&view, &event);
    }
  }
  SceneView view;
};

/// The pixels of a picture within `around` logical pixels of a place that fit.
template <class Fits>
int count(const QImage& picture, const QPointF& at, double around, Fits fits) {
  const double scale = picture.devicePixelRatio();
  int found = 0;
  for (int y = qRound(scale * (at.y() - around)); y <= qRound(scale * (at.y() + around)); ++y) {
    for (int x = qRound(scale * (at.x() - around)); x <= qRound(scale * (at.x() + around)); ++x) {
      if (picture.valid(x, y) && fits(picture.pixelColor(x, y))) ++found;
    }
  }
  return found;
}

inline bool isBlue(const QColor& c) {
  return c.blue() - c.red() > 20 && c.hue() > 180 && c.hue() < 230;
}
inline bool isGreen(const QColor& c) {
  return c.saturation() > 150 && c.hue() > 150 && c.hue() < 180;
}
inline bool isOrange(const QColor& c) {
  return c.saturation() > 200 && c.hue() > 36 && c.hue() < 46;
}
inline bool isVermillion(const QColor& c) {
  return c.saturation() > 200 && c.hue() > 20 && c.hue() < 32;
}

inline bool isPurple(const QColor& c) {
  return c.saturation() > 60 && c.hue() > 312 && c.hue() < 342;
}

inline scene::Joint turning(const Vec3& axis, const Vec3& point_mm) {
  scene::Joint joint;
  joint.axis = axis;
  joint.point_mm = point_mm;
  return joint;
}

}  // namespace underact::gui::test
