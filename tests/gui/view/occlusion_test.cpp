#include <gtest/gtest.h>

#include "app/gui/view/gl_surface.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

// Off on software GL, which draws these tests: what a graphics card would draw is asked for here.
TEST(Occlusion, DarkensCreasesOfTheArmAndNeitherTheBackgroundNorWhatIsSeenThrough) {
  test::Shown shown(test::sceneOf(scene::Sphere{Vec3::Zero(), 30.0}), Camera::Isometric);
  shown.view.present(test::snapshotAt({0.010, 0.012, 0.040}, {0.010, 0.012, 0.040}, Vec3::Zero()));
  shown.view.moveCamera(Camera::Fit);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.view.moving(); }));
  const QImage without = shown.view.picture();
  shown.view.findChild<GlSurface*>()->setOcclusion(true);
  const QImage with = shown.view.picture();
  ASSERT_EQ(with.size(), without.size());
  const auto lightness = [](const QImage& picture, int x, int y) { return qGray(picture.pixel(x, y)); };
  int darker = 0, lighter = 0;
  for (int y = 0; y < with.height(); ++y) {
    for (int x = 0; x < with.width(); ++x) {
      const int difference = lightness(with, x, y) - lightness(without, x, y);
      darker += difference < -8 ? 1 : 0;
      lighter += difference > 8 ? 1 : 0;
    }
  }
  EXPECT_GT(darker, 100);  // pixels of 800 by 600: the arm's joints
  EXPECT_LT(lighter, darker / 10);
  EXPECT_LE(std::abs(lightness(with, 5, 5) - lightness(without, 5, 5)), 1);
  EXPECT_EQ(shown.view.glErrors(), 0);
}

}  // namespace
}  // namespace underact::gui
