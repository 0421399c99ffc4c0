#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <string>

#include "tests/stories/story.h"

// A window does without any of its features: each is a room and a row, and nobody else knows it.
namespace underact::gui::test {
namespace {

/// It opens a scene, lets the servo push, takes a step back, changes its theme and closes.
void useIt(const std::vector<FeatureRow>& rows) {
  Story story("02_sphere", {.features = rows});
  EXPECT_TRUE(story.perform("session.start"));
  story.run(800);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  EXPECT_TRUE(story.perform("view.theme.dark"));
  EXPECT_TRUE(story.perform("layout.reset"));
  EXPECT_EQ(docksOf(&story.window()).size(), static_cast<qsizetype>(panelsOf(rows).size()));
  EXPECT_TRUE(story.perform("session.stop"));
  story.run(400);
  for (const QMenu* menu : story.window().findChildren<QMenu*>())
    for (const QAction* action : menu->actions()) EXPECT_FALSE(!action->isSeparator() && action->text().isEmpty());
}

TEST(FeaturesStory, TheWindowDoesWithoutAnyOneOfThem) {
  const std::vector<FeatureRow> all = features();
  ASSERT_GT(all.size(), 30U);
  for (std::size_t left_out = 0; left_out < all.size(); ++left_out) {
    std::vector<FeatureRow> rows = all;
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(left_out));
    SCOPED_TRACE("without row " + std::to_string(left_out));
    useIt(rows);
  }
}

TEST(FeaturesStory, TheWindowDoesWithoutAllOfThem) {
  useIt({});
}

}  // namespace
}  // namespace underact::gui::test
