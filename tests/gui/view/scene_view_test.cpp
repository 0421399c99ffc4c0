#include <gtest/gtest.h>

#include <QMainWindow>
#include <QSignalSpy>
#include <cmath>

#include "app/gui/view/arm_picture.h"
#include "app/gui/view/gl_surface.h"
#include "core/base/units.h"
#include "core/scene/compile.h"
#include "tests/core/scene/scene_support.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

using test::count;
using test::sceneOf;
using test::Shown;
using test::snapshotAt;

const scene::Shape kSphere = scene::Sphere{Vec3::Zero(), 30.0};
const Vec3 kNoForce = Vec3::Zero();
const Vec3 kTipInFront(0.010, 0.012, 0.040);  // in front of the sphere, seen from the front

QPointF alongScreen(const QPointF& from, const QPointF& to, double share) {
  return from + share * (to - from);
}

struct Place {
  const char* name;
  scene::Shape shape;
  Vec3 on_mm;   // drawn in blue here
  Vec3 off_mm;  // and not here
};

class SceneViewShape : public ::testing::TestWithParam<Place> {};

TEST_P(SceneViewShape, IsBlueWhereItIs) {
  Shown shown(sceneOf(GetParam().shape), Camera::Isometric);
  Layers layers;
  layers.workspace = layers.triads = layers.arm = false;
  shown.view.setLayers(layers);
  const QImage picture = shown.view.picture();
  EXPECT_GT(count(picture, shown.view.screenOf(1e-3 * GetParam().on_mm), 2.0, test::isBlue), 0);
  EXPECT_EQ(count(picture, shown.view.screenOf(1e-3 * GetParam().off_mm), 2.0, test::isBlue), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Every, SceneViewShape,
    ::testing::Values(Place{"point", scene::Point{{20, 10, 5}}, {20, 10, 5}, {-20, 10, 5}},
                      Place{"sphere", kSphere, {0, 30, 0}, {0, 50, 0}},
                      Place{"line", scene::Line{{0, 10, 0}, {1, 0, 0}}, {70, 10, 0}, {0, 40, 0}},
                      Place{"plane", scene::Plane{{0, -20, 0}, {0, 1, 0}}, {33, -20, 31}, {0, 50, 0}},
                      Place{"circle", scene::Circle{Vec3::Zero(), {0, 0, 1}, 40.0}, {0, 40, 0}, {10, 10, 0}},
                      Place{"cylinder", scene::Cylinder{Vec3::Zero(), {1, 0, 0}, 20.0}, {33, 20, 0}, {0, 60, 0}},
                      Place{"box", scene::Box{{0, 0, 0}, {60, 40, 30}}, {30, 20, 15}, {60, 40, 15}}),
    [](const auto& place) { return place.param.name; });

TEST(SceneView, EveryShapeIsBlueWhereItsNearestPointIs) {
  const Vec3 p_WT(0.045, 0.05, 0.055);  // on the side of the eye
  for (const scene::Shape& shape : underact::test::plainShapes(underact::test::FillSizes{})) {
    scene::Description scene = sceneOf(shape);
    scene.title = "One";
    const tick::TickProgram program = compile(scene).value();
    Shown shown(scene, Camera::Isometric);
    Layers layers;
    layers.workspace = layers.triads = layers.arm = false;
    shown.view.setLayers(layers);
    const auto& held = std::get<target::NearestOnShape>(program.entries[0].constraint.goal);
    const QPointF there = shown.view.screenOf(closestPoint(held.shape, p_WT).p_WP);
    EXPECT_GT(count(shown.view.picture(), there, 2.0, test::isBlue), 0) << typeName(shape);
  }
}

TEST(SceneView, ForceArrowIsOrangeAndALimitMakesItVermillionWithABar) {
  Shown shown(sceneOf(kSphere));
  const Vec3 target = kTipInFront + Vec3(0.001, 0, 0);
  shown.view.present(snapshotAt(kTipInFront, target, {0.44, 0, 0}));  // half of what the arm holds: 30 mm
  const QPointF tip = shown.view.screenOf(kTipInFront), half = shown.view.screenOf(kTipInFront + Vec3(0.015, 0, 0));
  EXPECT_GT(count(shown.view.picture(), half, 2.0, test::isOrange), 0);

  shown.view.present(snapshotAt(kTipInFront, target, {20.0, 0, 0}));  // cut to 0.88 N: 60 mm
  const QImage cut = shown.view.picture();
  const QPointF end = shown.view.screenOf(kTipInFront + Vec3(0.060, 0, 0));
  EXPECT_GT(count(cut, alongScreen(tip, end, 0.5), 2.0, test::isVermillion), 0);
  EXPECT_EQ(count(cut, alongScreen(tip, end, 0.5), 6.0, test::isOrange), 0);
  for (const double side : {-0.005, 0.005}) {  // the bar stands out on both sides, where the head has ended
    const QPointF bar = shown.view.screenOf(kTipInFront + Vec3(0.060, side, 0));
    EXPECT_GT(count(cut, bar, 1.5, test::isVermillion), 0) << side;
  }
}

TEST(SceneView, AFaultShowsARingAndNoArrow) {
  Shown shown(sceneOf(kSphere));
  servo::Snapshot snapshot = snapshotAt(kTipInFront, kTipInFront, {0.8, 0, 0});
  shown.view.present(snapshot);
  const QPointF tip = shown.view.screenOf(kTipInFront), on_arrow = shown.view.screenOf(kTipInFront + Vec3(0.035, 0, 0));
  ASSERT_GT(count(shown.view.picture(), on_arrow, 2.0, test::isOrange), 0);
  snapshot.report.fault = {FaultKind::NoSample, 20, 20};
  snapshot.mode = servo::Mode::Faulted;
  shown.view.present(snapshot);
  const QImage picture = shown.view.picture();
  EXPECT_EQ(count(picture, on_arrow, 6.0, test::isOrange), 0);
  for (const QPointF& out : {QPointF(17, 0), QPointF(-17, 0), QPointF(0, 17), QPointF(6, 6), QPointF(-6, -6)}) {
    EXPECT_GT(count(picture, tip + out, 1.5, test::isVermillion), 0) << out.x() << ' ' << out.y();
  }
}

TEST(SceneView, TargetIsAGreenMarkerAtTheEndOfALine) {
  Shown shown(sceneOf(kSphere));
  const Vec3 target = kTipInFront + Vec3(0.030, 0, 0);
  shown.view.present(snapshotAt(kTipInFront, target, kNoForce));
  EXPECT_GT(count(shown.view.picture(), shown.view.screenOf(target), 2.0, test::isGreen), 0);
  EXPECT_GT(count(shown.view.picture(), shown.view.screenOf(kTipInFront + Vec3(0.015, 0, 0)), 2.0, test::isGreen), 0);
  Layers layers;
  layers.target = false;
  shown.view.setLayers(layers);
  EXPECT_EQ(count(shown.view.picture(), shown.view.screenOf(target), 4.0, test::isGreen), 0);
}

TEST(SceneView, ADragOnTheTipMovesTheHandAsFarAsThePointer) {
  Shown shown(sceneOf(kSphere));
  shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
  QSignalSpy grabbed(&shown.view, &SceneView::handGrabbed), released(&shown.view, &SceneView::handReleased);
  sim::HandSetpoint setpoint;
  QObject::connect(&shown.view, &SceneView::handMoved, [&](const sim::HandSetpoint& moved) { setpoint = moved; });
  const QPointF tip = shown.view.screenOf(kTipInFront);
  const double pixels_per_mm = shown.view.screenOf(kTipInFront + Vec3(0.001, 0, 0)).x() - tip.x();
  shown.drag(tip + QPointF(3, 4), tip + QPointF(43, 24));
  EXPECT_EQ(grabbed.count(), 1);
  EXPECT_EQ(released.count(), 1);
  const Vec3 travel_mm = 1e3 * (setpoint.p_WT - kTipInFront);
  EXPECT_NEAR(travel_mm.x(), 40.0 / pixels_per_mm, 0.01);
  EXPECT_NEAR(travel_mm.y(), -20.0 / pixels_per_mm, 0.01);
  EXPECT_NEAR(travel_mm.z(), 0.0, 1e-9);
  EXPECT_FALSE(setpoint.turns);
}

TEST(SceneView, TheNextDragGoesOnFromTheWishAndNotFromTheTip) {
  Shown shown(sceneOf(kSphere));
  shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
  std::vector<Vec3> setpoints;
  QObject::connect(&shown.view, &SceneView::handMoved,
                   [&](const sim::HandSetpoint& moved) { setpoints.push_back(moved.p_WT); });
  const QPointF tip = shown.view.screenOf(kTipInFront);
  shown.drag(tip, tip + QPointF(60, 0));  // the tip is held where it is: contact
  const Vec3 first = setpoints.back();
  shown.drag(tip, tip + QPointF(0, 10));
  EXPECT_NEAR(setpoints.back().x(), first.x(), 1e-9);
  sim::HandSetpoint elsewhere;
  elsewhere.p_WT = Vec3(0.001, 0.002, 0.003);
  shown.view.setHandSetpoint(elsewhere);
  shown.drag(tip, tip + QPointF(0, 10));
  EXPECT_NEAR(setpoints.back().x(), 0.001, 1e-9);
}

TEST(SceneView, TheWishStaysWithinReach) {
  Shown shown(sceneOf(kSphere));
  shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
  sim::HandSetpoint setpoint;
  QObject::connect(&shown.view, &SceneView::handMoved, [&](const sim::HandSetpoint& moved) { setpoint = moved; });
  const QPointF tip = shown.view.screenOf(kTipInFront);
  shown.drag(tip, tip + QPointF(4000, 0));
  EXPECT_NEAR(setpoint.p_WT.norm(), 0.15, 1e-9);
}

TEST(SceneView, OrbitAndPanMoveThePictureAndNotTheHand) {
  for (const Qt::KeyboardModifiers modifiers : {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ShiftModifier)}) {
    Shown shown(sceneOf(kSphere));
    shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
    QSignalSpy moved(&shown.view, &SceneView::handMoved), grabbed(&shown.view, &SceneView::handGrabbed);
    const QPointF tip = shown.view.screenOf(kTipInFront), from = modifiers == Qt::NoModifier ? QPointF(60, 420) : tip;
    shown.drag(from, from + QPointF(50, 10), Qt::LeftButton, modifiers);
    EXPECT_EQ(moved.count() + grabbed.count(), 0);
    EXPECT_GT(std::abs(shown.view.screenOf(kTipInFront).x() - tip.x()), 3.0);
  }
}

TEST(SceneView, OrbitEndsAboveAndBelowAndNothingStandsOnItsHead) {
  for (const double delta : {4000.0, -4000.0}) {
    Shown shown(sceneOf(kSphere));
    shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
    shown.drag({60, 300}, QPointF(60, 300 + delta));
    EXPECT_NEAR(shown.view.viewpoint().camera.elevation_rad, std::copysign(0.5 * kPi, delta), 1e-12);
  }
}

TEST(SceneView, TheWheelZoomsTowardsThePointer) {
  Shown shown(sceneOf(kSphere));
  const Vec3 p(0.02, 0.01, 0), q(0.03, 0.01, 0);
  const auto length = [&] { return shown.view.screenOf(q).x() - shown.view.screenOf(p).x(); };
  const double before = length();
  shown.wheel(shown.view.screenOf(p), 3);
  EXPECT_GT(length(), 1.3 * before);
  shown.wheel(shown.view.screenOf(p), -3);
  EXPECT_NEAR(length(), before, 1e-6);
}

TEST(SceneView, TheWheelMovesAHeldHandInDepth) {
  Shown shown(sceneOf(kSphere));
  shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
  sim::HandSetpoint setpoint;
  QObject::connect(&shown.view, &SceneView::handMoved, [&](const sim::HandSetpoint& moved) { setpoint = moved; });
  const QPointF tip = shown.view.screenOf(kTipInFront);
  shown.send(QEvent::MouseButtonPress, tip, Qt::LeftButton, Qt::LeftButton);
  shown.wheel(tip, 2, Qt::LeftButton);
  EXPECT_TRUE(setpoint.p_WT.isApprox(kTipInFront - Vec3(0, 0, 0.010), 1e-9)) << setpoint.p_WT.transpose();
  EXPECT_NEAR(shown.view.screenOf(kTipInFront).x(), tip.x(), 1e-9);
}

TEST(SceneView, ArrowKeysMoveTheHandTwoMillimetresAlongTheAxesOfW) {
  for (const Camera camera : {Camera::Front, Camera::Isometric}) {
    Shown shown(sceneOf(kSphere), camera);
    shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
    shown.moveCamera(camera);
    Vec3 setpoint = kTipInFront;
    bool turns = false;
    QObject::connect(&shown.view, &SceneView::handMoved, [&](const sim::HandSetpoint& moved) {
      setpoint = moved.p_WT;
      turns = moved.turns;
    });
    QSignalSpy grabbed(&shown.view, &SceneView::handGrabbed), released(&shown.view, &SceneView::handReleased);
    const auto step = [&](int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
      const Vec3 before = setpoint;
      shown.key(key, modifiers);
      return Vec3(1e3 * (setpoint - before));
    };
    EXPECT_TRUE(step(Qt::Key_Right).isApprox(Vec3(2, 0, 0), 1e-9));
    EXPECT_TRUE(step(Qt::Key_Up).isApprox(Vec3(0, 2, 0), 1e-9));
    EXPECT_TRUE(step(Qt::Key_PageUp).isApprox(Vec3(0, 0, -2), 1e-9));
    EXPECT_TRUE(step(Qt::Key_Left, Qt::ShiftModifier).isApprox(Vec3(-10, 0, 0), 1e-9));
    EXPECT_FALSE(turns);
    EXPECT_TRUE(step(Qt::Key_Up, Qt::ControlModifier).isZero());
    EXPECT_TRUE(turns);
    EXPECT_EQ(grabbed.count(), 5);
    EXPECT_EQ(released.count(), 5);
  }
}

TEST(SceneView, CtrlDragTurnsTheStylusFromWhereItIs) {
  Shown shown(sceneOf(kSphere));
  const servo::Snapshot snapshot = snapshotAt(kTipInFront, kTipInFront, kNoForce);
  shown.view.present(snapshot);
  sim::HandSetpoint setpoint;
  QObject::connect(&shown.view, &SceneView::handMoved, [&](const sim::HandSetpoint& moved) { setpoint = moved; });
  QObject::connect(&shown.view, &SceneView::handGrabbed,
                   [&] {  // as the window does it: it knows the place, not the turn
                     sim::HandSetpoint known;
                     known.p_WT = kTipInFront;
                     shown.view.setHandSetpoint(known);
                   });
  const QPointF tip = shown.view.screenOf(kTipInFront);
  shown.drag(tip, tip + QPointF(20, 0), Qt::LeftButton, Qt::ControlModifier);
  const Mat3 R_WT = arm::tipPose(test::preset().geometry, snapshot.report.sample.q_rad).linear();
  const Mat3 expected = Eigen::AngleAxisd(10.0 * kRadPerDegree, Vec3::UnitY()) * R_WT;
  EXPECT_TRUE(setpoint.turns);
  EXPECT_TRUE(setpoint.R_WT.isApprox(expected, 1e-9));
  EXPECT_TRUE(setpoint.p_WT.isApprox(kTipInFront, 1e-12));
}

TEST(SceneView, AHandThatOnlyTurnsIsLooseUnlessItKeepsHoldingOrHasMoved) {
  Shown shown(sceneOf(kSphere));
  shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
  std::vector<bool> holds;
  QObject::connect(&shown.view, &SceneView::handMoved,
                   [&](const sim::HandSetpoint& moved) { holds.push_back(moved.holds); });
  const QPointF tip = shown.view.screenOf(kTipInFront);
  shown.drag(tip, tip + QPointF(20, 0), Qt::LeftButton, Qt::ControlModifier);
  EXPECT_TRUE(holds.front()) << "as long as the button is only down";
  EXPECT_FALSE(holds.back());
  shown.key(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_FALSE(holds.back());
  shown.key(Qt::Key_Left);
  EXPECT_TRUE(holds.back());
  shown.view.setKeepsHolding(true);
  shown.key(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_TRUE(holds.back());
  shown.view.setKeepsHolding(false);
  shown.send(QEvent::MouseButtonPress, tip, Qt::LeftButton, Qt::LeftButton);
  shown.send(QEvent::MouseMove, tip + QPointF(9, 0), Qt::NoButton, Qt::LeftButton);
  shown.send(QEvent::MouseMove, tip + QPointF(9, 9), Qt::NoButton, Qt::LeftButton, Qt::ControlModifier);
  EXPECT_TRUE(holds.back()) << "moved first, then turned";
}

TEST(SceneView, TheStylusIsGrabbedFifteenPixelsBesideItAndByItsGimbal) {
  Shown shown(sceneOf(kSphere));
  const servo::Snapshot snapshot = snapshotAt(kTipInFront, kTipInFront, kNoForce);
  shown.view.present(snapshot);
  QSignalSpy grabbed(&shown.view, &SceneView::handGrabbed);
  const QPointF tip = shown.view.screenOf(kTipInFront);
  const Mat3 R_WT = arm::tipPose(preset().geometry, snapshot.report.sample.q_rad).linear();
  const QPointF body = shown.view.screenOf(kTipInFront + 0.05 * R_WT.col(2));
  const QPointF along = body - tip;
  const QPointF aside = QPointF(-along.y(), along.x()) / std::hypot(along.x(), along.y());
  int places = 0;
  for (const QPointF& place :
       {tip + 15.0 * aside, body - 15.0 * aside, tip - 0.5 * along / std::hypot(along.x(), along.y()) * 28.0}) {
    shown.drag(place, place + QPointF(4, 0));
    EXPECT_EQ(grabbed.count(), ++places);
  }
}

TEST(SceneView, EachPartOfTheGimbalIsGrabbedAndTheArmIsNot) {
  Shown shown(sceneOf(kSphere));
  const servo::Snapshot snapshot = snapshotAt(kTipInFront, kTipInFront, kNoForce);
  shown.view.present(snapshot);
  QSignalSpy grabbed(&shown.view, &SceneView::handGrabbed);
  ArmPicture arm;
  ASSERT_TRUE(arm.present(snapshot.report.sample.q_rad));
  ASSERT_FALSE(arm.gimbalRods().empty());
  int places = 0;
  for (const ShadowRod& rod : arm.gimbalRods()) {
    const QPointF place = shown.view.screenOf(0.5 * (rod.from_W + rod.to_W));
    shown.drag(place, place + QPointF(4, 0));
    EXPECT_EQ(grabbed.count(), ++places);
  }
  const QPointF elbow = shown.view.screenOf(arm::skeleton(preset().geometry, snapshot.report.sample.q_rad).p_WElbow);
  shown.drag(elbow, elbow + QPointF(4, 0));
  EXPECT_EQ(grabbed.count(), places);
}

TEST(SceneView, ThePointerShowsWhatItCanGrab) {
  Shown shown(sceneOf(kSphere));
  shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
  const QPointF tip = shown.view.screenOf(kTipInFront);
  shown.send(QEvent::MouseMove, tip + QPointF(5, 5), Qt::NoButton, Qt::NoButton);
  EXPECT_EQ(shown.view.cursor().shape(), Qt::OpenHandCursor);
  shown.send(QEvent::MouseButtonPress, tip, Qt::LeftButton, Qt::LeftButton);
  EXPECT_EQ(shown.view.cursor().shape(), Qt::ClosedHandCursor);
  shown.send(QEvent::MouseButtonRelease, tip, Qt::LeftButton, Qt::NoButton);
  shown.send(QEvent::MouseMove, {20, 20}, Qt::NoButton, Qt::NoButton);
  EXPECT_EQ(shown.view.cursor().shape(), Qt::ArrowCursor);
  shown.view.setHandAvailable(false);
  shown.send(QEvent::MouseMove, tip, Qt::NoButton, Qt::NoButton);
  EXPECT_EQ(shown.view.cursor().shape(), Qt::ArrowCursor);
}

TEST(SceneView, BackgroundIsFlatAndExact) {
  Shown shown(sceneOf(kSphere));
  shown.view.clearFocus();
  for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
    shown.view.setTheme(theme);
    const QImage picture = shown.view.picture();
    for (const QPoint& corner : {QPoint(9, 9), QPoint(picture.width() - 9, 9)}) {
      EXPECT_EQ(picture.pixelColor(corner).name().toStdString(), theme.background.name().toStdString());
    }
  }
}

TEST(SceneView, EverythingFitsFromEverySide) {
  Shown shown(sceneOf(kSphere));
  shown.view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
  for (const Camera camera : {Camera::Front, Camera::Back, Camera::Left, Camera::Right, Camera::Top, Camera::Bottom,
                              Camera::Isometric, Camera::Fit}) {
    shown.moveCamera(camera);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p((corner & 1) != 0 ? 0.08 : -0.08, (corner & 2) != 0 ? 0.06 : -0.06,
                   (corner & 4) != 0 ? 0.035 : -0.035);
      EXPECT_TRUE(QRectF(0, 0, 800, 600).contains(shown.view.screenOf(p)))
          << static_cast<int>(camera) << ' ' << p.transpose();
    }
  }
  shown.moveCamera(Camera::Top);  // from above, the user below the picture
  EXPECT_GT(shown.view.screenOf(Vec3(0, 0, 0.03)).y(), shown.view.screenOf(Vec3::Zero()).y());
  EXPECT_GT(shown.view.screenOf(Vec3(0.03, 0, 0)).x(), shown.view.screenOf(Vec3::Zero()).x());
}

TEST(SceneView, AFirstPoseThatComesDuringALookIsFittedToo) {
  Shown shown(sceneOf(kSphere));
  shown.view.moveCamera(Camera::Right);
  const servo::Snapshot snapshot = snapshotAt(kTipInFront, kTipInFront, kNoForce);
  shown.view.present(snapshot);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.view.moving(); }));
  const arm::Skeleton skeleton = arm::skeleton(test::preset().geometry, snapshot.report.sample.q_rad);
  for (const Vec3& p : {skeleton.p_WShoulder, skeleton.p_WElbow}) {
    EXPECT_TRUE(QRectF(0, 0, 800, 600).contains(shown.view.screenOf(p)));
  }
}

TEST(SceneView, DrawsAPictureWithoutBeingShown) {
  SceneView view;
  view.resize(500, 400);
  view.setScene(sceneOf(kSphere));
  view.present(snapshotAt(kTipInFront, kTipInFront, kNoForce));
  const QImage picture = view.picture();
  EXPECT_EQ(picture.size(), QSize(500, 400) * picture.devicePixelRatio());
  EXPECT_GT(count(picture, view.screenOf(Vec3(-0.020, -0.020, 0)), 2.0, test::isBlue), 0);
}

TEST(SceneView, LivesOnInAnotherWindow) {
  QMainWindow first, second;
  auto* view = new SceneView;
  view->setScene(sceneOf(kSphere));
  for (QMainWindow* window : {&first, &second, &first, &second}) {
    window->setCentralWidget(view);
    window->resize(700, 500);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window));
    view->moveCamera(Camera::Front);
    ASSERT_TRUE(QTest::qWaitFor([view] { return !view->moving(); }));
    view->present(snapshotAt(kTipInFront, kTipInFront, {0.1, 0, 0}));
    const QImage picture = view->picture();
    EXPECT_GT(count(picture, view->screenOf(Vec3(-0.015, -0.015, 0)), 2.0, test::isBlue), 0);
    EXPECT_EQ(view->glErrors(), 0);
    window->takeCentralWidget();
  }
  view->show();  // on its own, as a floating dock
  ASSERT_TRUE(QTest::qWaitForWindowExposed(view));
  EXPECT_GT(count(view->picture(), view->screenOf(Vec3(-0.015, -0.015, 0)), 2.0, test::isBlue), 0);
  EXPECT_EQ(view->glErrors(), 0);
  delete view;
}

TEST(SceneView, AnotherSceneLeavesNothingOfTheOldOne) {
  Shown shown(sceneOf(kSphere));
  const QPointF inside = shown.view.screenOf(Vec3(-0.015, -0.015, 0));
  ASSERT_GT(count(shown.view.picture(), inside, 2.0, test::isBlue), 0);
  shown.view.setScene(sceneOf(scene::Point{{60, 40, 0}}));
  shown.moveCamera(Camera::Front);
  EXPECT_EQ(count(shown.view.picture(), shown.view.screenOf(Vec3(-0.015, -0.015, 0)), 2.0, test::isBlue), 0);
  EXPECT_EQ(shown.view.glErrors(), 0);
}

TEST(SceneView, WhatLooksTheSameIsNotDrawnAgain) {
  Shown shown(sceneOf(kSphere));
  const servo::Snapshot snapshot = snapshotAt(kTipInFront, kTipInFront, {0.1, 0, 0});
  shown.view.present(snapshot);
  QTest::qWait(100);
  const qint64 before = shown.view.framesDrawn();
  for (int again = 0; again < 5; ++again) {
    shown.view.present(snapshot);
    QTest::qWait(10);
  }
  EXPECT_EQ(shown.view.framesDrawn(), before);
  shown.view.present(snapshotAt(kTipInFront + Vec3(0.001, 0, 0), kTipInFront, {0.1, 0, 0}));
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown.view.framesDrawn() > before; }));
}

TEST(SceneView, TheHintIsShownAndAJointThatIsNoNumberLeavesTheStylusWhereItWas) {
  Shown shown(sceneOf(kSphere));
  shown.view.setHint(QStringLiteral("Drag the stylus with the mouse."));
  EXPECT_GT(count(shown.view.picture(), {400, 30}, 14.0, [](const QColor& c) { return c.lightness() < 90; }), 20);
  servo::Snapshot snapshot = snapshotAt(kTipInFront, kTipInFront, kNoForce);
  shown.view.present(snapshot);
  snapshot.report.sample.q_rad[1] = kNotANumber;
  snapshot.report.held[0].p_WP = Vec3::Constant(kNotANumber);
  shown.view.present(snapshot);
  EXPECT_GT(count(shown.view.picture(), shown.view.screenOf(kTipInFront), 3.0,
                  [](const QColor& c) { return c.lightness() < 60; }),
            4);
}

}  // namespace
}  // namespace underact::gui
