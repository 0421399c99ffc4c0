#include <gtest/gtest.h>

#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolButton>

#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

void openMenu(Story& story) {
  QMenuBar* bar = story.window().menuBar();
  story.click(bar, bar->actionGeometry(bar->actions().first()).center());
  ASSERT_NE(QApplication::activePopupWidget(), nullptr);
}

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

TEST(StopStory, EscClosesAMenuADialogASearchAndTheTourBeforeItStops) {
  Story story("02_sphere");
  story.perform("session.start");
  openMenu(story);
  QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
  story.settle();
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  EXPECT_TRUE(story.host().running()) << "the menu took it";

  story.perform("help.about");
  QPointer<QWidget> about = story.find("dialog.about");
  story.bringToFront(about);
  story.key(Qt::Key_Escape);
  story.settle();
  EXPECT_TRUE(about.isNull());
  EXPECT_TRUE(story.host().running()) << "the dialog took it";

  story.bringToFront(&story.window());
  auto* filter = story.find<QLineEdit>("panel.scenes.filter");
  filter->setFocus();
  filter->setText("mesh");
  story.key(Qt::Key_Escape);
  EXPECT_TRUE(filter->text().isEmpty());
  EXPECT_TRUE(story.host().running()) << "the search took it";

  story.perform("help.tour");
  story.key(Qt::Key_Escape);
  EXPECT_FALSE(story.find("tour")->isVisible());
  EXPECT_TRUE(story.host().running()) << "the tour took it";
  expectStops(story, "nothing open");
}

TEST(StopStory, ShiftEscStopsInAnOpenMenuAndInAnOpenDialog) {
  Story story("02_sphere");
  story.perform("session.start");
  openMenu(story);
  QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape, Qt::ShiftModifier);
  EXPECT_FALSE(story.host().running());
  while (QApplication::activePopupWidget() != nullptr) QApplication::activePopupWidget()->close();

  story.perform("session.start");
  story.perform("help.about");
  story.bringToFront(story.find("dialog.about"));
  story.key(Qt::Key_Escape, Qt::ShiftModifier);
  EXPECT_FALSE(story.host().running());
}

TEST(StopStory, WhileItIsStoppedTheViewSaysSoAndAClickStarts) {
  Story story("02_sphere");
  auto* banner = story.find<QPushButton>("view.stopped");
  EXPECT_EQ(banner->text(), "Force is off. Start (F5)");
  EXPECT_EQ(banner->accessibleName(), banner->text());
  story.perform("session.start");
  story.run(100);
  EXPECT_FALSE(banner->isVisible());
  story.key(Qt::Key_Escape);
  story.run(300);
  ASSERT_TRUE(banner->isVisible());
  EXPECT_TRUE(story.view().rect().contains(banner->geometry()));
  story.savePicture("stopped");
  story.click(banner);
  story.run(100);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  EXPECT_FALSE(banner->isVisible());
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
