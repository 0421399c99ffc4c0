#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

using test::count;
using test::Shown;

constexpr double kRadius_m = 0.040;

Vec3 onRing(double angle_deg) {
  return kRadius_m * Vec3(std::cos(kRadPerDegree * angle_deg), std::sin(kRadPerDegree * angle_deg), 0.0);
}

/// A ring about W's z, seen from the front: the stylus points at 0 degrees, the tip is at 120.
servo::Snapshot influenced(double share) {
  const Vec3 target_W = onRing(120.0 * share);
  servo::Snapshot snapshot = test::snapshotAt(Vec3(-0.025, 0.040, -0.020), target_W, Vec3::Zero());
  target::Arc& arc = snapshot.report.held[0].arc;
  arc.p_WPo = onRing(0.0);
  arc.p_WPp = onRing(120.0);
  arc.axis_W = Vec3::UnitZ();
  arc.turn_rad = 120.0 * kRadPerDegree;
  arc.share = share;
  return snapshot;
}

// The very colours: the ring's own blue has the hue of the sky blue, and fades towards it at its edges.
bool isNear(const QColor& c, const QColor& wanted) {
  return std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) + std::abs(c.blue() - wanted.blue()) <
         40;
}
bool isOrientation(const QColor& c) {
  return isNear(c, Theme::light().orientation);
}
bool isPosition(const QColor& c) {
  return isNear(c, Theme::light().position);
}

Layers withoutTheRest() {
  Layers layers;
  layers.workspace = layers.triads = layers.arm = layers.force = false;
  return layers;
}

const scene::Shape kRing = scene::Circle{Vec3::Zero(), Vec3::UnitZ(), 1000.0 * kRadius_m};

}  // namespace

TEST(InfluencePicture, RingsAndTheArcAreWhereTheTickSaysAndTheWayTheTargetWentIsStronger) {
  Shown shown(test::sceneOf(kRing));
  shown.view.setLayers(withoutTheRest());
  shown.view.present(influenced(0.5));
  const QImage picture = shown.view.picture();
  const auto near = [&](double angle_deg, double around, bool (*fits)(const QColor&)) {
    return count(picture, shown.view.screenOf(onRing(angle_deg)), around, fits);
  };
  EXPECT_GT(near(0.0, 11.0, isOrientation), 20);
  EXPECT_GT(near(120.0, 11.0, isPosition), 20);
  EXPECT_GT(near(30.0, 4.0, isOrientation), 20);  // on the way the target has gone
  EXPECT_GT(near(90.0, 4.0, isPosition), 5);      // on the rest of it
  EXPECT_LT(near(90.0, 4.0, isPosition), near(30.0, 4.0, isOrientation));
  EXPECT_EQ(near(90.0, 4.0, isOrientation), 0);
  EXPECT_EQ(near(-60.0, 6.0, isOrientation) + near(-60.0, 6.0, isPosition), 0);  // not the other way round
  const Vec3 along = Vec3::UnitZ().cross(onRing(60.0)).normalized();
  EXPECT_GT(count(picture, shown.view.screenOf(onRing(60.0) + 0.018 * along), 2.0, test::isGreen), 0);  // the tangent
}

TEST(InfluencePicture, TheLayerTakesItAwayAndAnArcWithOneEndHasNoRingAtTheOther) {
  Shown shown(test::sceneOf(kRing));
  shown.view.setLayers(withoutTheRest());
  servo::Snapshot snapshot = influenced(1.0);
  target::Arc& arc = snapshot.report.held[0].arc;
  arc.p_WPo.setConstant(kNotANumber);
  arc.turn_rad = 0.0;
  shown.view.present(snapshot);
  EXPECT_EQ(count(shown.view.picture(), shown.view.screenOf(onRing(0.0)), 11.0, isOrientation), 0);
  EXPECT_GT(count(shown.view.picture(), shown.view.screenOf(onRing(120.0)), 11.0, isPosition), 20);
  Layers layers = withoutTheRest();
  layers.influence = false;
  shown.view.setLayers(layers);
  EXPECT_EQ(count(shown.view.picture(), shown.view.screenOf(onRing(120.0)), 11.0, isPosition), 0);
  EXPECT_EQ(shown.view.glErrors(), 0);
}

}  // namespace underact::gui
