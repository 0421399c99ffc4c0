#include <gtest/gtest.h>

#include "app/gui/view/hand_picture.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

const scene::Shape kBallOfDimples = scene::Sphere{Vec3::Zero(), 40.0};

servo::Snapshot pressed(double force_N) {
  const Vec3 normal = Vec3(0.3, 0.2, 1.0).normalized();
  return test::snapshotAt(0.038 * normal, 0.040 * normal, force_N * normal);
}

}  // namespace

TEST(DimplePicture, ASurfaceGivesWhereTheTipIsPressedAgainstItAndACurveDoesNot) {
  HandPicture hand;
  hand.setScene(test::sceneOf(kBallOfDimples));
  hand.present(pressed(0.4));
  EXPECT_EQ(hand.dimplesDrawn(), 1U);
  hand.present(pressed(0.0));  // no force: stopped
  EXPECT_EQ(hand.dimplesDrawn(), 0U);
  servo::Snapshot free = pressed(0.4);
  free.report.held[0].acts = false;
  hand.present(free);
  EXPECT_EQ(hand.dimplesDrawn(), 0U);
  hand.show(true, true, false);
  hand.present(pressed(0.4));
  EXPECT_EQ(hand.dimplesDrawn(), 0U);  // with the force's layer
  hand.show(true, true, true);
  servo::Snapshot on_it = pressed(0.4);
  on_it.report.held[0].p_WP = on_it.report.p_WT;
  hand.present(on_it);
  EXPECT_LE(hand.dimplesDrawn(), 1U);  // its direction is that of rounding
  hand.setScene(test::sceneOf(scene::Circle{Vec3::Zero(), Vec3::UnitZ(), 40.0}));
  hand.present(pressed(0.4));
  EXPECT_EQ(hand.dimplesDrawn(), 0U);
}

TEST(DimplePicture, IsWiderWithMoreForce) {
  test::Shown shown(test::sceneOf(kBallOfDimples), Camera::Front);
  Layers layers;
  layers.workspace = layers.triads = layers.arm = layers.target = false;
  shown.view.setLayers(layers);
  // Beside the arrow, 3 mm from the target: the blue of the surface, or that and the orange of the dimple's middle.
  const auto brownAt3mm = [&](double force_N) {
    const servo::Snapshot snapshot = pressed(force_N);
    shown.view.present(snapshot);
    const Vec3& target_W = snapshot.report.held[0].p_WP;
    const Vec3 beside_W = target_W + 0.003 * target_W.cross(Vec3::UnitY()).normalized();
    return test::count(shown.view.picture(), shown.view.screenOf(beside_W), 1.0,
                       [](const QColor& c) { return c.red() > c.blue(); });
  };
  EXPECT_EQ(brownAt3mm(0.0), 0);
  EXPECT_EQ(brownAt3mm(0.05), 0);
  EXPECT_GT(brownAt3mm(0.8), 0);
  EXPECT_EQ(shown.view.glErrors(), 0);
}

}  // namespace underact::gui
