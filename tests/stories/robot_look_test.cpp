#include <QApplication>
#include <QHeaderView>
#include <QListWidget>
#include <QPushButton>

#include "tests/stories/picture_difference.h"
#include "tests/stories/robot_desk.h"

namespace underact::gui::test {

TEST(RobotLookStory, ItIsSeenWhereOpaqueChildrenCoverAllOfIt) {
  Robot story("16_one_joint_robot");
  auto* const panel = story.find("panel.robot");
  QWidget cover(panel);
  cover.setAttribute(Qt::WA_OpaquePaintEvent);
  cover.setGeometry(panel->rect());
  cover.show();
  ASSERT_TRUE(panel->visibleRegion().isEmpty());
  const QString before = story.readout("Joint q1");
  story.hold({0.050, 0.0, 0.0}, Vec3(1.0, 0.35, 0.0));
  EXPECT_NE(story.readout("Joint q1"), before);
}

TEST(RobotLookStory, TheShapePanelSaysWhatTheRobotIsAndOpensItsJoints) {
  Story story("23_two_beams");
  story.perform("dock.shape", true);
  story.settle();
  QStringList texts;
  for (const QLabel* label : story.find("panel.shape")->findChildren<QLabel*>()) texts << label->text();
  EXPECT_TRUE(texts.contains("Virtual robot"));
  EXPECT_TRUE(texts.contains("Springs"));
  story.click(story.find("panel.shape.edit_robot"));
  story.settle();
  EXPECT_FALSE(story.find("panel.robot.joints")->visibleRegion().isEmpty());
  story.perform("scene.open", shippedScene("02_sphere"));
  EXPECT_FALSE(story.find("panel.shape.edit_robot")->isVisible());
}

TEST(RobotLookStory, RobotsHaveAHeadingOfTheirOwnInTheListOfScenes) {
  Story story("02_sphere");
  const auto* list = story.find<QListWidget>("panel.scenes.list");
  int shapes = -1, robots = -1;
  for (int row = 0; row < list->count(); ++row) {
    if (list->item(row)->text() == "Shapes") shapes = row;
    if (list->item(row)->text() == "Virtual robots") robots = row;
  }
  EXPECT_EQ(shapes, 0);
  ASSERT_GT(robots, 10);
  EXPECT_EQ(list->item(robots + 1)->text(), "A robot of one joint");
  EXPECT_FALSE(list->item(robots + 1)->icon().isNull());
}

TEST(RobotLookStory, EachRobotLooksAsItDid) {
  for (const char* name : {"16_one_joint_robot", "18_sphere_of_two_joints", "21_puma_560", "22_out_of_reach"}) {
    Robot story(name);
    story.hold({0.012, 0.018, 0.034});
    EXPECT_EQ(story.view().robotsDrawn(), 1u);
    EXPECT_LT(story.imageDifference(name), kTolerance) << name;
  }
  Robot dark("18_sphere_of_two_joints");
  dark.perform("view.theme.dark");
  dark.hold({0.012, 0.018, 0.034});
  EXPECT_LT(dark.imageDifference("robot_dark"), kTolerance);
}

TEST(RobotLookStory, NothingIsCutAtTheUsualTextNorAtTwiceIt) {
  const QFont default_value = QApplication::font();
  for (const double share : {1.0, 2.0}) {
    QFont font = default_value;
    font.setPointSizeF(share * default_value.pointSizeF());
    QApplication::setFont(font);
    {
      Robot story("21_puma_560", {.size = {1920, 1080}});
      story.hold({0.012, 0.018, 0.034});
      story.settle();
      for (const QLabel* label : story.find("panel.robot")->findChildren<QLabel*>()) {
        if (!label->isVisible() || label->text().isEmpty() || label->wordWrap()) continue;
        EXPECT_GE(label->width(), label->fontMetrics().horizontalAdvance(label->text())) << label->text().toStdString();
      }
      for (const char* name : {"panel.robot.joints", "panel.robot.home"}) {
        const auto* table = story.find<QTableWidget>(name);
        for (int column = 0; column < table->columnCount(); ++column) {
          for (int row = 0; row < table->rowCount(); ++row) {
            EXPECT_GE(table->columnWidth(column),
                      table->fontMetrics().horizontalAdvance(table->item(row, column)->text()) + 6)
                << name << ' ' << row << ' ' << column;
          }
        }
        EXPECT_GE(table->verticalHeader()->sectionSize(0), table->fontMetrics().height());
      }
      for (const QPushButton* button : story.find("panel.robot")->findChildren<QPushButton*>()) {
        EXPECT_GE(button->width(), button->fontMetrics().horizontalAdvance(button->text()))
            << button->text().toStdString();
      }
      EXPECT_TRUE(
          story.picture().save(QString("%1/pictures/window_robot_text_%2.png").arg(UNDERACT_BINARY).arg(share)));
    }
  }
  QApplication::setFont(default_value);
}

// To be looked at by people: build/.../pictures/window_robot_THEME.png.
TEST(RobotLookStory, TheWindowOfARobot) {
  for (const char* theme : {"light", "dark"}) {
    Robot story("16_one_joint_robot");
    story.perform(QString("view.theme.") + theme);
    story.hold({0.046, 0.012, 0.0}, Vec3(1.0, 0.9, 0.2));
    story.view().setHint({});
    story.settle(300);
    EXPECT_TRUE(story.picture().save(QString("%1/pictures/window_robot_%2.png").arg(UNDERACT_BINARY).arg(theme)));
  }
  Robot puma("21_puma_560");
  puma.hold({0.012, 0.018, 0.034});
  puma.view().setHint({});
  puma.settle(300);
  EXPECT_TRUE(puma.picture().save(QString("%1/pictures/window_robot_puma.png").arg(UNDERACT_BINARY)));
}

}  // namespace underact::gui::test
