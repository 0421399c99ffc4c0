#include <gtest/gtest.h>

#include <QDockWidget>
#include <QWheelEvent>

#include "app/gui/model/player.h"
#include "app/gui/plot/live_plot.h"
#include "tests/stories/story.h"

namespace underact::gui::test {

TEST(PlotsStory, AnyColumnIsPlottedReadAndEnlarged) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("dock.plots", true));
  ASSERT_TRUE(story.perform("plots.columns", "z_mm", "heat_1"));
  EXPECT_FALSE(story.perform("plots.columns", "z_mm", "nonsense"));
  ASSERT_TRUE(story.perform("plots.columns", "z_mm", "heat_1"));
  story.perform("session.start");
  story.run(3000);
  story.settle(200);
  auto* const plot = story.find<LivePlot>("panel.plots.plot");
  EXPECT_TRUE(plot->dataText('\t').contains("z_mm"));
  EXPECT_FALSE(plot->showsPart());
  const QPointF at(0.12 * plot->width(), 0.5 * plot->height());
  QWheelEvent turn(at, plot->mapToGlobal(at), {}, {0, 360}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(plot, &turn);
  EXPECT_TRUE(plot->showsPart());
  EXPECT_TRUE(story.perform("plots.hold", true));
  story.run(2000);
  EXPECT_TRUE(plot->holds());
  story.savePicture("plots_columns");
  EXPECT_TRUE(story.perform("plots.hold", false));
  plot->showAll();
}

TEST(PlotsStory, HowTheStylusIsTurnedIsPlottedLiveAndFromASession) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("dock.plots", true));
  ASSERT_TRUE(story.perform("plots.columns", "quat_WT_w"));
  story.perform("session.start");
  story.run(1500);
  story.settle(200);
  EXPECT_TRUE(story.find<LivePlot>("panel.plots.plot")->dataText('\t').contains("quat_WT_w"));
  ASSERT_TRUE(story.perform("replay.open", QString(UNDERACT_SOURCE "/tests/golden/session.h5")));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        story.window().frame();
        return story.window().player().isOpen();
      },
      kLong_ms));
  ASSERT_TRUE(story.perform("dock.session", true));
  ASSERT_TRUE(story.perform("session.columns", "quat_WT_w", "quat_WT_x"));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        story.window().frame();
        const QString data = story.find<ChartWidget>("panel.session.plot")->dataText('\t');
        return data.contains("quat_WT_x") && data.count('\n') > 3;
      },
      kLong_ms));
}

TEST(PlotsStory, AtTheFirstStartPlotsNumbersAndFramesAreFoldedAway) {
  Story story("02_sphere");
  for (const char* key : {"plots", "shape", "arm"})
    EXPECT_TRUE(story.find<QDockWidget>(QString("dock.%1").arg(key))->isHidden()) << key;
  for (const char* key : {"scenes", "feel"})
    EXPECT_FALSE(story.find<QDockWidget>(QString("dock.%1").arg(key))->isHidden()) << key;
  EXPECT_FALSE(story.view().layers().workspace);
  EXPECT_FALSE(story.view().layers().triads);
  story.savePicture("first_start");
  story.perform("purpose.research");
  story.settle();
  story.click(story.find("rail.plots"));
  story.settle();
  EXPECT_FALSE(story.find<QDockWidget>("dock.plots")->isHidden());
  EXPECT_GT(story.find("dock.plots")->height(), 180);
  story.click(story.find("rail.plots"));
  story.settle();
  EXPECT_TRUE(story.find<QDockWidget>("dock.plots")->isHidden());
}

TEST(PlotsStory, AtEverySizeNothingIsBeyondTheWindowAndTheRailHasNames) {
  for (const QSize& size : {QSize(1280, 800), QSize(1024, 700), QSize(1900, 1000)}) {
    Story story("02_sphere", {.size = size});
    story.settle(100);
    const QWidget* const rail = story.find("rail");
    EXPECT_TRUE(story.window().rect().contains(rail->geometry())) << size.width();
    EXPECT_LE(story.window().width(), size.width());
    EXPECT_LE(story.window().height(), size.height());
    for (const char* name : {"rail.scenes", "rail.feel", "rail.more"}) {
      const QWidget* const button = story.find(name);
      EXPECT_TRUE(button->isVisible()) << name << size.width();
      EXPECT_GE(button->width(), button->sizeHint().width()) << name;
    }
    story.savePicture(QString("room_%1").arg(size.width()));
  }
}

}  // namespace underact::gui::test
