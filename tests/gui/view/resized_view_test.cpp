#include <gtest/gtest.h>

#include <QScreen>
#include <cmath>

#include "tests/gui/example.h"

namespace underact::gui {
namespace {

/// How many pixels differ clearly.
int differing(const QImage& one, const QImage& other) {
  int count = 0;
  for (int y = 0; y < std::min(one.height(), other.height()); ++y) {
    for (int x = 0; x < std::min(one.width(), other.width()); ++x)
      count += std::abs(qGray(one.pixel(x, y)) - qGray(other.pixel(x, y))) > 40 ? 1 : 0;
  }
  return count;
}

TEST(ResizedView, ShowsWhatItsCameraSees) {
  test::Shown shown(test::sceneOf(scene::Sphere{Vec3::Zero(), 30.0}), Camera::Fit);
  shown.view.present(test::snapshotAt({0.010, 0.012, 0.040}, {0.010, 0.012, 0.040}, Vec3::Zero()));
  for (const QSize size : {QSize(1200, 700), QSize(500, 900)}) {
    shown.view.resize(size);
    QTest::qWait(300);
    // What stands on the screen, which is not drawn anew for being asked.
    const QImage on_screen = shown.view.screen()->grabWindow(shown.view.winId()).toImage();
    const QImage anew = shown.view.picture();
    ASSERT_EQ(on_screen.size(), size);
    ASSERT_EQ(anew.size(), size);
    EXPECT_LT(differing(on_screen, anew), 50) << size.width();
  }
}

}  // namespace
}  // namespace underact::gui
