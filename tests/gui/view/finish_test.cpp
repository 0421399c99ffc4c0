#include <gtest/gtest.h>

#include <set>

#include "app/gui/kit/contrast.h"
#include "app/gui/view/arm_picture.h"
#include "app/gui/view/shadow_picture.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

const scene::Shape kSmallBall = scene::Sphere{Vec3::Zero(), 30.0};
const Vec3 kNearUser(0.010, 0.012, 0.040);

TEST(Desk, IsSeenUnderTheArmInEachThemeAndNeitherWithoutItNorFromBelow) {
  for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
    test::Shown shown(test::sceneOf(kSmallBall), Camera::Home);
    shown.view.setTheme(theme);
    shown.view.present(test::snapshotAt(kNearUser, kNearUser, Vec3::Zero()));
    shown.moveCamera(Camera::Home);
    const ArmStand stand = standOf(*arm::findModel(arm::kDefaultArm));
    const Vec3 p_W = stand.p_WG + stand.R_WD * (stand.p_DTop + Vec3(-0.2, 0.0, 0.0));  // where nothing stands
    const auto colour = [&] {
      const QImage picture = shown.view.picture();
      return picture.pixelColor((picture.devicePixelRatio() * shown.view.screenOf(p_W)).toPoint());
    };
    EXPECT_GT(contrastOf(colour(), theme.background), 1.04);
    Layers layers = shown.view.layers();
    layers.arm = false;
    shown.view.setLayers(layers);
    EXPECT_EQ(colour().name().toStdString(), theme.background.name().toStdString());
    layers.arm = true;
    shown.view.setLayers(layers);
    shown.moveCamera(Camera::Bottom);
    EXPECT_EQ(colour().name().toStdString(), theme.background.name().toStdString());
  }
}

TEST(Desk, AShadowHasNoSawTeethHoweverFarTheArmReaches) {
  // A foot, and an arm far from it.
  const std::vector<ShadowRod> rods{{{0, 0, 0}, {0, 0.1, 0}, 0.05, 0.05}, {{0, 0.1, 0}, {0.6, 0.15, 0.5}, 0.02, 0.02}};
  const ShadowField field = shadowOf(rods, Pose::Identity(), 1.0);
  constexpr std::size_t n = ShadowField::kPoints;
  float steepest = 0.0F, darkest = 0.0F;
  for (std::size_t at = 0; at < field.shade.size(); ++at) {
    darkest = std::max(darkest, field.shade[at]);
    if (at % n != 0) steepest = std::max(steepest, std::abs(field.shade[at] - field.shade[at - 1]));
    if (at >= n) steepest = std::max(steepest, std::abs(field.shade[at] - field.shade[at - n]));
  }
  EXPECT_GT(darkest, 0.9F);    // in contact
  EXPECT_LT(steepest, 0.45F);  // from point to point of its grid
}

TEST(ArmPicture, IsOfTwoMaterialsThatAreToldApart) {
  std::set<Finish> seen;
  for (const ArmSolid& solid : solidsOf(*arm::findModel(arm::kDefaultArm)).solids) seen.insert(solid.finish);
  EXPECT_TRUE(seen.contains(Finish::Shell) && seen.contains(Finish::Metal));
  for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
    const Finishes finishes = armFinishes(theme);
    EXPECT_GT(contrastOf(finishes[static_cast<std::size_t>(Finish::Shell)],
                         finishes[static_cast<std::size_t>(Finish::Metal)]),
              2.0);
  }
}

/// What of the view the arm takes up: it alone is as dark.
QRectF armIn(const QImage& picture) {
  QRect box;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x)
      if (qGray(picture.pixel(x, y)) < 90) box |= QRect(x, y, 1, 1);
  }
  const double scale = picture.devicePixelRatio();
  return {box.x() / scale, box.y() / scale, box.width() / scale, box.height() / scale};
}

TEST(Composition, FillsTheViewAndDoesSoAgainWhenItIsResizedUntilAPersonMovesIt) {
  test::Shown shown(test::sceneOf(kSmallBall), Camera::Home);
  shown.view.showWords(false);
  Layers layers;
  layers.workspace = layers.triads = false;
  shown.view.setLayers(layers);
  shown.view.present(test::snapshotAt(kNearUser, kNearUser, Vec3::Zero()));
  shown.moveCamera(Camera::Home);
  for (const QSize size : {QSize(587, 703), QSize(374, 590), QSize(620, 500)}) {
    shown.view.resize(size);
    ASSERT_TRUE(QTest::qWaitFor([&] { return shown.view.size() == size; }));
    const QRectF box = armIn(shown.view.picture());
    EXPECT_GT(std::max(box.width() / size.width(), box.height() / (size.height() - 44.0)), 0.8) << size.width();
    EXPECT_TRUE(QRectF(QPointF(3, 3), size - QSize(6, 6)).contains(box))
        << size.width() << ": " << box.left() << " to " << box.right() << ", " << box.top() << " to " << box.bottom();
  }
  shown.drag({300, 300}, {320, 300});
  const double distance_mm = shown.view.viewpoint().camera.distance_mm;
  shown.view.resize(500, 590);
  QTest::qWait(50);
  EXPECT_EQ(shown.view.viewpoint().camera.distance_mm, distance_mm);
}

TEST(GlSurface, APictureAtRestIsSmoothedWithoutAFrameMore) {
  test::Shown shown(test::sceneOf(kSmallBall), Camera::Home);
  shown.view.present(test::snapshotAt(kNearUser, kNearUser, {0.3, 0.0, 0.0}));
  const qint64 frames = shown.view.framesDrawn();
  QTest::qWait(500);
  EXPECT_LE(shown.view.framesDrawn(), frames + 1);
  EXPECT_EQ(shown.view.glErrors(), 0);
}

}  // namespace
}  // namespace underact::gui
