#include <gtest/gtest.h>

#include <QSettings>
#include <QSignalSpy>
#include <cmath>

#include "app/gui/view/axis_gizmo.h"
#include "app/gui/view/view_memory.h"
#include "core/base/units.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

using test::Shown;

const QSizeF kSize(800.0, 600.0);
const scene::Shape kBall = scene::Sphere{Vec3::Zero(), 30.0};

OrbitCamera someCamera(bool parallel) {
  OrbitCamera camera;
  camera.focus_mm = Vec3(10.0, 20.0, 30.0);
  camera.azimuth_rad = 0.6;
  camera.elevation_rad = 0.3;
  camera.parallel = parallel;
  return camera;
}

/// The settings of the test program, without any.
class ViewMemoryOnDisk : public ::testing::Test {
 protected:
  void SetUp() override { QSettings().clear(); }
};

}  // namespace

TEST(OrbitCamera, InParallelProjectionDepthChangesNothingAndTheFocalPlaneKeepsItsScale) {
  const OrbitCamera parallel = someCamera(true), perspective = someCamera(false);
  const Vec3 p_mm = parallel.focus_mm + 30.0 * parallel.right_W() + 12.0 * parallel.up_W();
  const QPointF here = project(parallel, kSize, p_mm).pixel;
  const QPointF behind = project(parallel, kSize, p_mm - 200.0 * parallel.back_W()).pixel;
  EXPECT_NEAR(here.x(), behind.x(), 1e-6);
  EXPECT_NEAR(here.y(), behind.y(), 1e-6);
  EXPECT_NEAR(here.x(), project(perspective, kSize, p_mm).pixel.x(), 1e-6);
  EXPECT_GT(std::abs(project(perspective, kSize, p_mm - 200.0 * parallel.back_W()).pixel.x() - here.x()), 1.0);
}

TEST(OrbitCamera, FittedInParallelProjectionAllPointsAreInsideTheMarginsAndTwoAtEachOfTheTighterOnes) {
  const std::vector<Vec3> points{{-90, 0, 0}, {110, 20, 5}, {0, -40, 70}, {10, 55, -30}};
  const QMarginsF room(50.0, 60.0, 40.0, 30.0);
  const OrbitCamera camera = fitted(someCamera(true), kSize, points, room);
  double left = kInfinity, right = -kInfinity, top = kInfinity, bottom = -kInfinity;
  for (const Vec3& p_mm : points) {
    const QPointF at = project(camera, kSize, p_mm).pixel;
    left = std::min(left, at.x());
    right = std::max(right, at.x());
    top = std::min(top, at.y());
    bottom = std::max(bottom, at.y());
  }
  EXPECT_GE(left, 50.0 - 1e-6);
  EXPECT_LE(right, 760.0 + 1e-6);
  EXPECT_GE(top, 60.0 - 1e-6);
  EXPECT_LE(bottom, 570.0 + 1e-6);
  EXPECT_TRUE((std::abs(left - 50.0) < 1e-6 && std::abs(right - 760.0) < 1e-6) ||
              (std::abs(top - 60.0) < 1e-6 && std::abs(bottom - 570.0) < 1e-6));
}

TEST(OrbitCamera, LooksFromAnyDirectionOfAnyArmsUp) {
  for (const bool z_up : {false, true}) {
    OrbitCamera camera = someCamera(false);
    if (z_up) camera.R_WD << Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY();
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        const Vec3 from_W = side * Vec3::Unit(axis);
        EXPECT_NEAR(lookingFrom(camera, from_W).back_W().dot(from_W), 1.0, 1e-12) << axis << ' ' << side;
      }
    }
  }
}

TEST(SceneViewCamera, AClickOnABallOfTheAxesLooksFromThereAndASecondOneFromTheOtherSide) {
  Shown shown(test::sceneOf(kBall), Camera::Home);
  const auto clickBall = [&](const Vec3& from_W) {
    const OrbitCamera camera = shown.view.viewpoint().camera;
    for (double x = -46.0; x <= 46.0; x += 2.0) {
      for (double y = -46.0; y <= 46.0; y += 2.0) {
        const QPointF at = AxisGizmo::middle(kSize) + QPointF(x, y);
        const std::optional<Vec3> ball = AxisGizmo::ballAt(at, kSize, camera);
        if (!ball || !ball->isApprox(from_W)) continue;
        shown.send(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
        EXPECT_EQ(shown.view.cursor().shape(), Qt::PointingHandCursor);
        shown.drag(at, at);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !shown.view.moving(); }));
        return true;
      }
    }
    return false;
  };
  for (const Vec3& from_W : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(-Vec3::UnitZ())}) {
    shown.moveCamera(Camera::Home);
    ASSERT_TRUE(clickBall(from_W));
    EXPECT_NEAR(shown.view.viewpoint().camera.back_W().dot(from_W), 1.0, 1e-9);
    ASSERT_TRUE(clickBall(from_W));
    EXPECT_NEAR(shown.view.viewpoint().camera.back_W().dot(from_W), -1.0, 1e-9);
    EXPECT_TRUE(shown.view.viewpoint().fits);
  }
}

TEST(SceneViewCamera, InParallelProjectionThePictureIsWhereThePointsAreAndTheStylusIsStillGrabbed) {
  Shown shown(test::sceneOf(kBall));
  const Vec3 tip_W(0.010, 0.012, 0.040);
  shown.view.present(test::snapshotAt(tip_W, tip_W + Vec3(0.030, 0.0, 0.0), Vec3::Zero()));
  QSignalSpy changed(&shown.view, &SceneView::parallelChanged);
  shown.view.setParallel(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.view.moving(); }));
  EXPECT_TRUE(shown.view.isParallel());
  EXPECT_EQ(changed.count(), 1);
  shown.moveCamera(Camera::Front);
  const QPointF target = shown.view.screenOf(tip_W + Vec3(0.030, 0.0, 0.0));
  EXPECT_GT(test::count(shown.view.picture(), target, 2.0, test::isGreen), 0);
  const QPointF front = shown.view.screenOf(Vec3(0.08, 0.06, 0.035)),
                back = shown.view.screenOf(Vec3(0.08, 0.06, -0.035));
  EXPECT_NEAR(front.x(), back.x(), 1e-6);
  Vec3 hand_W = Vec3::Zero();
  QObject::connect(&shown.view, &SceneView::handMoved, [&](const sim::HandSetpoint& moved) { hand_W = moved.p_WT; });
  const QPointF tip = shown.view.screenOf(tip_W);
  const double pixels_per_m = 1e3 * (shown.view.screenOf(tip_W + Vec3(0.001, 0, 0)).x() - tip.x());
  shown.drag(tip, tip + QPointF(40.0, 0.0));
  EXPECT_NEAR(hand_W.x() - tip_W.x(), 40.0 / pixels_per_m, 1e-6);
  EXPECT_EQ(shown.view.glErrors(), 0);
}

TEST(SceneViewCamera, ZoomToSelectionIsNearerThanAllAndHomeComesBack) {
  Shown shown(test::sceneOf(kBall), Camera::Home);
  const Vec3 tip_W(0.010, 0.012, 0.040);
  shown.view.present(test::snapshotAt(tip_W, tip_W, Vec3::Zero()));
  shown.moveCamera(Camera::Home);
  const Viewpoint home = shown.view.viewpoint();
  shown.view.fitSelection();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.view.moving(); }));
  EXPECT_LT(shown.view.viewpoint().camera.distance_mm, 0.7 * home.camera.distance_mm);
  for (const Vec3& p_W : {Vec3(0.03, 0, 0), Vec3(-0.03, 0, 0), Vec3(0, 0.03, 0), tip_W})
    EXPECT_TRUE(QRectF(QPointF(), kSize).contains(shown.view.screenOf(p_W)));
  shown.drag({300, 60}, {420, 90});
  shown.moveCamera(Camera::Home);
  EXPECT_NEAR(shown.view.viewpoint().camera.azimuth_rad, home.camera.azimuth_rad, 1e-12);
  EXPECT_NEAR(shown.view.viewpoint().camera.distance_mm, home.camera.distance_mm, 1e-6);
}

TEST_F(ViewMemoryOnDisk, ASceneLooksAsItWasLeftAndAnotherOneFits) {
  Shown shown(test::sceneOf(kBall), Camera::Home);
  Viewpoint moved;
  {
    ViewMemory memory(shown.view);
    memory.enter("/a.json");
    shown.drag({300, 60}, {420, 90});
    shown.view.setParallel(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.view.moving(); }));
    moved = shown.view.viewpoint();
    ASSERT_FALSE(moved.fits);
    memory.enter("/b.json");
    EXPECT_TRUE(shown.view.viewpoint().fits);
    memory.enter({});  // a recording
    memory.enter("/a.json");
    EXPECT_NEAR(shown.view.viewpoint().camera.azimuth_rad, moved.camera.azimuth_rad, 1e-6);
    memory.keep();
  }
  shown.view.setParallel(false);
  shown.moveCamera(Camera::Front);
  ViewMemory next_day(shown.view);
  next_day.enter("/a.json");
  EXPECT_NEAR(shown.view.viewpoint().camera.azimuth_rad, moved.camera.azimuth_rad, 1e-6);
  EXPECT_NEAR(shown.view.viewpoint().camera.distance_mm, moved.camera.distance_mm, 1e-3);
  EXPECT_TRUE(shown.view.isParallel());
  EXPECT_FALSE(shown.view.viewpoint().fits);
}

TEST_F(ViewMemoryOnDisk, ADamagedEntryIsIgnoredAndThereAreNotMoreThanTheMost) {
  QSettings().setValue("view/of_scenes", QStringList{"/a.json\tnan 1 2 3 4 5 0 0", "/b.json", "/c.json\t1 2"});
  Shown shown(test::sceneOf(kBall), Camera::Home);
  const Viewpoint before = shown.view.viewpoint();
  ViewMemory memory(shown.view);
  for (const char* path : {"/a.json", "/b.json", "/c.json"}) {
    memory.enter(path);
    EXPECT_EQ(shown.view.viewpoint(), before) << path;
  }
  for (int scene = 0; scene < ViewMemory::kMax + 5; ++scene) {
    memory.enter(QString("/%1.json").arg(scene));
    Viewpoint viewpoint = shown.view.viewpoint();
    viewpoint.fits = false;
    shown.view.setViewpoint(viewpoint);
  }
  memory.keep();
  EXPECT_EQ(QSettings().value("view/of_scenes").toStringList().size(), ViewMemory::kMax);
}

}  // namespace underact::gui
