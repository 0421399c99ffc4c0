#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "app/gui/kit/number_table.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

struct ExploreDesk {
  explicit ExploreDesk(const char* panel) : story("02_sphere") {
    story.perform(QString("dock.%1").arg(panel), true);
    story.perform("session.start");
    story.run(200);
  }
  QString number(const char* table, int row, int column) { return story.find<NumberTable>(table)->text(row, column); }
  QString textOf(const char* label) { return story.find<QLabel>(label)->text(); }
  bool isThere(const char* name) { return story.find(name)->isVisible(); }
  int rows(const char* table) { return story.find<QTableWidget>(table)->rowCount(); }
  void press(const char* button) { story.click(story.find(button)); }

  Story story;
};

/// How far the table's tip is from the arm's, mm.
double away_mm(ExploreDesk& desk) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double difference = desk.number("panel.dh.tip", 1, axis).replace(QChar(0x2212), '-').toDouble();
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

}  // namespace

TEST(ExploreStory, TheArmsOwnTableCoversTheArmWhereverTheHandGoes) {
  ExploreDesk desk("dh");
  EXPECT_EQ(desk.story.view().framesInDrawings(), 6U);
  desk.story.dragHandTo({0.02, 0.03, 0.06});
  desk.story.run(800);
  EXPECT_EQ(away_mm(desk), 0.0);
  ASSERT_TRUE(desk.story.perform("dh.set", 2, QString("alpha"), QString("0")));  // it was 90 degrees
  desk.story.run(200);
  EXPECT_GT(away_mm(desk), 10.0);
  desk.story.savePicture("dh_table");
  desk.press("panel.dh.undo");
  desk.story.run(200);
  EXPECT_EQ(away_mm(desk), 0.0);
  desk.press("panel.dh.redo");
  desk.story.run(200);
  EXPECT_GT(away_mm(desk), 10.0);
}

TEST(ExploreStory, AnImpossibleTableIsRefusedWithItsRowAndAnOddOneIsSaid) {
  ExploreDesk desk("dh");
  EXPECT_FALSE(desk.story.perform("dh.set", 3, QString("a"), QString("4000")));
  EXPECT_TRUE(desk.textOf("panel.dh.told").contains("row 3"));
  EXPECT_TRUE(desk.textOf("panel.dh.told").contains("1000 mm"));
  EXPECT_FALSE(desk.story.perform("dh.set", 3, QString("a"), QString("long")));
  EXPECT_TRUE(desk.isThere("panel.dh.told"));
  EXPECT_FALSE(desk.isThere("panel.dh.odd"));
  ASSERT_TRUE(desk.story.perform("dh.start", QString("planar")));
  EXPECT_FALSE(desk.isThere("panel.dh.told"));
  ASSERT_TRUE(desk.story.perform("dh.set", 2, QString("a"), QString("0")));
  EXPECT_TRUE(desk.textOf("panel.dh.odd").contains("Joints 1 and 2 turn about the same axis"));
  EXPECT_TRUE(desk.isThere("panel.dh.odd"));
}

TEST(ExploreStory, RowsComeAndGoAndJointsStayWhereTheyWereWhenTheyNoLongerFollow) {
  ExploreDesk desk("dh");
  ASSERT_TRUE(desk.story.perform("dh.start", QString("scara")));
  EXPECT_EQ(desk.rows("panel.dh.table"), 4);
  desk.press("panel.dh.add");
  EXPECT_EQ(desk.rows("panel.dh.table"), 5);
  EXPECT_EQ(desk.story.view().framesInDrawings(), 5U);
  desk.press("panel.dh.remove");
  EXPECT_EQ(desk.rows("panel.dh.table"), 4);
  desk.story.run(200);
  ASSERT_TRUE(desk.story.perform("dh.follow", false));
  const QString before = desk.number("panel.dh.tip", 0, 0);
  desk.story.dragHandTo({-0.03, 0.02, 0.06});
  desk.story.run(800);
  EXPECT_EQ(desk.number("panel.dh.tip", 0, 0), before);
  ASSERT_TRUE(desk.story.perform("dh.set", 4, QString("q"), QString("25")));  // the slide: along W's y, downwards
  ASSERT_TRUE(desk.story.perform("dh.follow", true));
  desk.story.run(400);
  EXPECT_NE(desk.number("panel.dh.tip", 0, 0), before);
}

TEST(ExploreStory, BothOrdersStandSideBySideAndTheOtherAxesAreTheOtherOrder) {
  ExploreDesk desk("transform");
  EXPECT_EQ(desk.story.view().framesInDrawings(), 2U);
  const auto matrix = [&](const char* table) {
    QStringList numbers;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) numbers << desk.number(table, row, column);
    }
    return numbers;
  };
  const QStringList listed = matrix("panel.transform.listed"), reversed = matrix("panel.transform.reversed");
  EXPECT_NE(listed, reversed);
  EXPECT_TRUE(desk.textOf("panel.transform.apart").contains("order matters"));
  EXPECT_EQ(listed[7], "40.0");  // Rz 90, then along what is now x: the old y
  desk.story.savePicture("transforms");
  ASSERT_TRUE(desk.story.perform("transform.axes", QString("fixed")));
  EXPECT_EQ(matrix("panel.transform.listed"), reversed);
  EXPECT_EQ(matrix("panel.transform.reversed"), listed);
  ASSERT_TRUE(desk.story.perform("transform.undo"));
  EXPECT_EQ(matrix("panel.transform.listed"), listed);
}

TEST(ExploreStory, StepsThatCommuteAreSaidToAndTooFarIsRefused) {
  ExploreDesk desk("transform");
  ASSERT_TRUE(desk.story.perform("transform.set", 1, QString("Dx"), QString("30")));
  ASSERT_TRUE(desk.story.perform("transform.set", 2, QString("Dy"), QString("-20")));
  ASSERT_TRUE(desk.story.perform("transform.set", 3, QString("Dz"), QString("10")));
  EXPECT_TRUE(desk.textOf("panel.transform.apart").contains("order does not matter"));
  EXPECT_FALSE(desk.story.perform("transform.set", 3, QString("Dz"), QString("900")));
  EXPECT_TRUE(desk.isThere("panel.transform.told"));
  desk.press("panel.transform.remove");
  desk.press("panel.transform.remove");
  EXPECT_EQ(desk.rows("panel.transform.steps"), 1);
  EXPECT_FALSE(desk.story.perform("transform.remove"));
}

TEST(ExploreStory, APanelThatIsNotSeenDrawsNothing) {
  ExploreDesk desk("dh");
  EXPECT_GT(desk.story.view().framesInDrawings(), 0U);
  desk.story.perform("dock.scenes", false);
  desk.story.perform("dock.scenes", true);  // before it now, in the same place
  desk.story.run(200);
  EXPECT_EQ(desk.story.view().framesInDrawings(), 0U);
}

}  // namespace underact::gui::test
