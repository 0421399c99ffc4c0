#include <gtest/gtest.h>

#include <QLineEdit>
#include <QListWidget>

#include "app/gui/kit/page_view.h"
#include "app/gui/model/scene_library.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow scenesFeature();
}

namespace underact::gui::test {
namespace {

/// The list's rows that are not hidden: headings and scenes.
QStringList rowsShown(Desk& desk) {
  const auto* list = desk.find<QListWidget>("panel.scenes.list");
  QStringList shown;
  for (int row = 0; row < list->count(); ++row)
    if (!list->item(row)->isHidden()) shown << list->item(row)->text();
  return shown;
}

}  // namespace

TEST(Scenes, EveryTextOfAShippedSceneCanBeDrawn) {
  for (const SceneEntry& entry : shippedScenes()) {
    ASSERT_TRUE(entry.teaching) << entry.path.toStdString();
    for (const std::string& text : {entry.teaching->feel, entry.teaching->try_this, entry.teaching->equation}) {
      PageView page;
      page.showPage(QString::fromStdString(text), {});
      for (const Problem& problem : page.page().problems)
        ADD_FAILURE() << entry.path.toStdString() << describe(problem);
    }
  }
}

TEST(ScenesPanel, TheFilterLeavesWhatFitsUnderItsHeadingAndNoOtherHeading) {
  Desk desk(scenesFeature());
  auto* filter = desk.find<QLineEdit>("panel.scenes.filter");
  const QStringList all = rowsShown(desk);
  EXPECT_TRUE(all.contains("Walls") && all.contains("Sphere"));
  filter->setText("SCARA");
  EXPECT_LT(rowsShown(desk).size(), all.size());
  EXPECT_TRUE(rowsShown(desk).contains("Virtual robots"));
  EXPECT_FALSE(rowsShown(desk).contains("Walls"));
  filter->setText("there is none of this");
  EXPECT_EQ(rowsShown(desk), QStringList());
}

TEST(ScenesPanel, TheOpenSceneIsTheChosenOneWithItsWordsAndAFileOfOnesOwnStandsBelow) {
  Desk desk(scenesFeature(), "05_circle");
  const auto* list = desk.find<QListWidget>("panel.scenes.list");
  ASSERT_NE(list->currentItem(), nullptr);
  EXPECT_EQ(list->currentItem()->text(), QString::fromStdString(desk.scene().title));
  EXPECT_TRUE(desk.find<PageView>("panel.scenes.about")->toPlainText().contains("Feel:"));
  EXPECT_FALSE(rowsShown(desk).contains("Recently opened"));
  const QString own = desk.fileOf("own.json", R"({"underact_scene": 1, "title": "My own ball", "constraints": [
    {"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 25}]})");
  ASSERT_TRUE(desk.perform("scene.open", own));
  EXPECT_TRUE(rowsShown(desk).contains("Recently opened"));
  EXPECT_EQ(list->currentItem()->text(), QString("My own ball"));
}

}  // namespace underact::gui::test
