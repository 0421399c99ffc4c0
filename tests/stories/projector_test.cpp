#include <gtest/gtest.h>

#include <QApplication>
#include <QStatusBar>
#include <QToolBar>

#include "tests/stories/docks_seen.h"
#include "tests/stories/story.h"

namespace underact::gui::test {

TEST(ProjectorStory, TheViewFillsTheWindowInLargeTypeAndEverythingIsAsItWasAfter) {
  Story story("02_sphere");
  story.perform("view.theme.light");
  const std::map<std::string, int> docks = docksSeen(story.window());
  const QFont font = story.view().font();
  const QSize size = story.view().size();
  const QPalette palette = QApplication::palette();
  ASSERT_TRUE(story.perform("view.projector", true));
  story.settle(100);
  EXPECT_EQ(docksSeen(story.window()).size(), 0u);
  EXPECT_FALSE(story.window().statusBar()->isVisible());
  EXPECT_TRUE(story.window().findChild<QToolBar*>()->isVisible());  // Start and Stop stay
  EXPECT_GT(story.view().width(), size.width() * 3 / 2);
  EXPECT_GT(story.view().font().pointSizeF(), 1.5 * font.pointSizeF());
  EXPECT_EQ(story.picture().pixelColor(story.view().mapTo(&story.window(), QPoint(8, 8))), QColor(Qt::white));
  ASSERT_TRUE(story.perform("view.projector", false));
  story.settle(100);
  EXPECT_EQ(docksSeen(story.window()), docks);
  EXPECT_EQ(story.view().font(), font);
  EXPECT_EQ(story.view().size(), size);
  EXPECT_EQ(QApplication::palette(), palette);
}

TEST(ProjectorStory, ItIsRememberedAndSoIsTheLayoutBehindIt) {
  {
    Story story("02_sphere");
    story.find("dock.scenes")->hide();
    story.perform("view.projector", true);
  }
  Story story({}, {.first_start = false});
  EXPECT_TRUE(story.window().actions().find("view.projector")->isChecked());
  EXPECT_EQ(docksSeen(story.window()).size(), 0u);
  story.perform("view.projector", false);
  story.settle();
  EXPECT_TRUE(story.find("dock.feel")->isVisible());
  EXPECT_FALSE(story.find("dock.scenes")->isVisible());
}

TEST(ProjectorStory, TheGaugeIsLargerThere) {
  Story story("02_sphere");
  const auto gaugeInk = [&story] {  // pixels that are not the ground, in the corner where the gauge stands
    const QImage image = story.view().picture();
    const QColor ground = image.pixelColor(2, 2);
    int ink = 0;
    for (int y = image.height() - 60; y < image.height(); ++y)
      for (int x = image.width() - 400; x < image.width(); ++x) ink += image.pixelColor(x, y) != ground ? 1 : 0;
    return ink;
  };
  story.perform("layer.arm", false);  // nor its shadow
  story.settle(300);
  const int default_value = gaugeInk();
  story.perform("view.projector", true);
  story.settle(300);
  EXPECT_GT(gaugeInk(), 2 * default_value);
}

TEST(ProjectorStory, PicturesOfIt) {
  for (const char* theme : {"light", "dark"}) {
    Story story("02_sphere");
    story.perform(QString("view.theme.") + theme);
    story.perform("view.projector", true);
    story.arm().setSetpoint({.p_WT = Vec3(0.012, 0.018, 0.034)});
    story.perform("session.start");
    story.run(2000);
    story.savePicture(QString("projector_") + theme);
  }
}

}  // namespace underact::gui::test
