#include <gtest/gtest.h>

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>

#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

void expectStops(Story& story, const char* where) {
  EXPECT_TRUE(story.host().running()) << where;
  story.key(Qt::Key_Escape);
  EXPECT_FALSE(story.host().running()) << where;
  story.run(200);
  EXPECT_EQ(story.force_N(), 0.0) << where;
}

}  // namespace

TEST(StopStory, EscStopsFromEveryWidgetThatTakesTheFocus) {
  Story story("02_sphere");
  int tried = 0;
  for (QWidget* widget : story.window().findChildren<QWidget*>()) {
    if ((widget->focusPolicy() & Qt::TabFocus) == 0 || !widget->isVisible() || !widget->isEnabled()) continue;
    widget->setFocus(Qt::TabFocusReason);
    if (!widget->hasFocus()) continue;
    story.perform("session.start");
    expectStops(story, widget->objectName().toUtf8().constData());
    ++tried;
  }
  EXPECT_GT(tried, 15);
}

TEST(StopStory, EscStopsWithAMenuOpenAndInADialog) {
  Story story("02_sphere");
  story.perform("session.start");
  QMenuBar* bar = story.window().menuBar();
  story.click(bar, bar->actionGeometry(bar->actions().first()).center());
  ASSERT_NE(QApplication::activePopupWidget(), nullptr);
  QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
  EXPECT_FALSE(story.host().running());
  story.settle();
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);  // and the menu closes, as menus do

  story.perform("session.start");
  story.perform("help.about");
  QWidget* about = story.find("dialog.about");
  ASSERT_TRUE(QTest::qWaitForWindowActive(about));
  expectStops(story, "dialog");
}

TEST(StopStory, TheBigButtonAndStartAreWhereTheySay) {
  Story story("02_sphere");
  auto* start = story.find<QToolButton>("button.session.start");
  auto* stop = story.find<QToolButton>("button.session.stop");
  EXPECT_EQ(start->text(), "Start");
  EXPECT_EQ(stop->text(), "Stop");
  story.click(start);
  story.run(500);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  EXPECT_GT(story.force_N(), 0.0);
  story.click(stop);
  story.run(500);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Idle);
  EXPECT_EQ(story.force_N(), 0.0);
}

}  // namespace underact::gui::test
