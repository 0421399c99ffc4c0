#include <gtest/gtest.h>

#include <QApplication>
#include <QStatusBar>
#include <QToolBar>

#include "tests/stories/docks_seen.h"
#include "tests/stories/story.h"
#include "tests/support/contrast.h"

namespace underact::gui::test {

using underact::test::contrast;

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
    story.find("dock.shape")->hide();
    story.perform("view.projector", true);
  }
  Story story({}, {.first_start = false});
  EXPECT_TRUE(story.window().actions().find("view.projector")->isChecked());
  EXPECT_EQ(docksSeen(story.window()).size(), 0u);
  story.perform("view.projector", false);
  story.settle();
  EXPECT_TRUE(story.find("dock.feel")->isVisible());
  EXPECT_FALSE(story.find("dock.shape")->isVisible());
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
  const int usual = gaugeInk();
  story.perform("view.projector", true);
  story.settle(300);
  EXPECT_GT(gaugeInk(), 2 * usual);
}

TEST(ProjectorStory, TextHasTheContrastOfWcagAaInEveryPalette) {
  for (const Theme& theme :
       {Theme::light(), Theme::dark_theme(), Theme::contrasting(false), Theme::contrasting(true)}) {
    const QPalette palette = paletteOf(theme);
    const std::string name = std::string(theme.dark ? "dark" : "light") + (theme.high_contrast ? " contrasting" : "");
    const double least = theme.high_contrast ? 7.0 : 4.5;  // AAA for the far end of the room
    EXPECT_GE(contrast(theme.ink, theme.background), least) << name;
    struct Pair {
      QPalette::ColorRole text, ground;
    };
    for (const Pair& pair :
         {Pair{QPalette::WindowText, QPalette::Window}, Pair{QPalette::Text, QPalette::Base},
          Pair{QPalette::ButtonText, QPalette::Button}, Pair{QPalette::ToolTipText, QPalette::ToolTipBase},
          Pair{QPalette::Text, QPalette::AlternateBase}})
      EXPECT_GE(contrast(palette.color(pair.text), palette.color(pair.ground)), least) << name << " " << pair.text;
    EXPECT_GE(contrast(palette.color(QPalette::Link), palette.color(QPalette::Base)), 4.5) << name;
    EXPECT_GE(contrast(mixed(theme.background, theme.ink, 0.68), palette.color(QPalette::Window)), 4.5)
        << name << ": quiet labels";
  }
}

TEST(ProjectorStory, WhatIsDrawnStandsOutFromTheGround) {
  for (const bool dark : {false, true}) {
    const Theme theme = Theme::contrasting(dark);
    for (const QColor& colour :
         {theme.constraint, theme.target, theme.orientation, theme.position, theme.force, theme.force_limited,
          theme.virtual_robot, theme.motion, theme.quiet, theme.x_axis, theme.y_axis, theme.z_axis})
      EXPECT_GE(contrast(colour, theme.background), 3.0) << colour.name().toStdString() << (dark ? " dark" : " light");
  }
}

TEST(ProjectorStory, PicturesOfIt) {
  for (const char* theme : {"light", "dark"}) {
    Story story("02_sphere");
    story.perform(QString("view.theme.") + theme);
    story.perform("view.projector", true);
    story.arm().wish({.p_WT = Vec3(0.012, 0.018, 0.034)});
    story.perform("session.start");
    story.run(2000);
    story.savePicture(QString("projector_") + theme);
  }
}

}  // namespace underact::gui::test
