#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

QStringList railOf(Story& story) {
  QStringList names;
  for (const QToolButton* const button : story.find("rail")->findChildren<QToolButton*>()) {
    if (button->objectName().startsWith("rail.")) names << button->objectName();
  }
  return names;
}

int entries(const QMenu* menu) {
  int count = 0;
  for (const QAction* const action : menu->actions())
    count += action->menu() != nullptr ? entries(action->menu()) : action->isSeparator() ? 0 : 1;
  return count;
}

int menuEntries(Story& story) {
  int count = 0;
  for (const QAction* const top : story.window().menuBar()->actions()) count += entries(top->menu());
  return count;
}

}  // namespace

TEST(PurposeStory, EachShowsItsPanelsMenusAndButtonsAndIsRemembered) {
  {
    Story story("02_sphere");
    EXPECT_EQ(railOf(story).size(), 6) << "five panels and all of them";
    EXPECT_EQ(story.window().findChild<QWidget*>("rail.lessons"), nullptr);
    story.savePicture("purpose_demonstrate");
    const int demonstrate = menuEntries(story);
    story.perform("purpose.teach");
    story.settle();
    EXPECT_TRUE(story.find("rail.lessons")->isVisible());
    EXPECT_TRUE(story.find("dock.lessons")->isVisible());
    EXPECT_FALSE(story.find("dock.scenes")->isVisible());
    story.savePicture("purpose_teach");
    story.perform("purpose.research");
    story.settle();
    EXPECT_TRUE(story.find("button.session.record")->isVisible());
    EXPECT_TRUE(story.find("dock.sessions")->isVisible());
    EXPECT_LT(demonstrate, menuEntries(story));
    story.savePicture("purpose_research");
    EXPECT_EQ(story.find<QToolButton>("button.purpose")->text(), QString("Research"));
  }
  Story story({}, {.first_start = false});
  EXPECT_TRUE(story.find("rail.lab")->isVisible());
}

TEST(PurposeStory, ALayoutComesBackWithItsPurposeAndAllPanelsAreOneStepAway) {
  Story story("02_sphere");
  story.find("dock.scenes")->hide();
  story.perform("purpose.teach");
  story.settle();
  story.perform("purpose.demonstrate");
  story.settle();
  EXPECT_FALSE(story.find("dock.scenes")->isVisible());
  const auto* const all = story.find<QMenu>("rail.more.menu");
  EXPECT_GT(entries(all), 15);
  story.perform("layout.reset");
  EXPECT_TRUE(story.find("dock.scenes")->isVisible());
  EXPECT_FALSE(story.find("dock.lessons")->isVisible());
}

TEST(PaletteStory, FindsAFieldAPageASceneAndALessonByAFewLetters) {
  Story story("02_sphere");
  story.byPalette("stiffness x");
  EXPECT_TRUE(QApplication::focusWidget() != nullptr &&
              QApplication::focusWidget()->objectName().startsWith("panel.gains.kp"));
  story.byPalette("scene circle");
  EXPECT_TRUE(story.window().windowTitle().startsWith("Circle")) << story.window().windowTitle().toStdString();
  story.perform("help.find");
  story.settle();
  EXPECT_TRUE(story.find("dialog.palette")->isVisible());
  story.key(Qt::Key_Escape);
  story.byPalette("lesson frames");
  EXPECT_TRUE(story.find("panel.lessons")->isVisible());
}

}  // namespace underact::gui::test
