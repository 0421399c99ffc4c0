#include <gtest/gtest.h>

#include <QCheckBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

#include "app/gui/servo/check_dialog.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
TEST(CheckStory, TheButtonMeasuresFillsTheTableAndSaysWhatItMeans) {
  Story story("02_sphere");
  story.perform("dock.servo", true);
  story.settle();
  story.find<QPushButton>("panel.servo.check")->click();
  auto* dialog = story.window().findChild<CheckDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->isModal()) << "Esc must stop the arm, whatever is open";
  dialog->findChild<QSpinBox*>()->setValue(2);
  dialog->findChild<QPushButton*>("dialog.check.begin")->click();
  EXPECT_TRUE(dialog->isRunning());
  EXPECT_FALSE(dialog->findChild<QCheckBox*>()->isEnabled());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog->isRunning(); }, 60'000));
  auto* table = dialog->findChild<QTableWidget*>();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      ASSERT_NE(table->item(row, column), nullptr) << row << ' ' << column;
      EXPECT_FALSE(table->item(row, column)->text().isEmpty());
    }
  }
  EXPECT_TRUE(dialog->message().contains("that of a bare loop at p99")) << dialog->message().toStdString();
  EXPECT_TRUE(dialog->findChild<QCheckBox*>()->isEnabled());
  story.settle();  // the words have another length than before
  EXPECT_TRUE(dialog->grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/dialog_check.png"));
}

TEST(CheckStory, EndingEarlyTellsWhatWasMeasuredAndClosingEndsIt) {
  Story story("02_sphere");
  story.perform("servo.check");
  auto* dialog = story.window().findChild<CheckDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* begin = dialog->findChild<QPushButton*>("dialog.check.begin");
  begin->click();  // of a minute
  begin->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog->isRunning(); }, 30'000));
  EXPECT_NE(dialog->message(), "");
  begin->click();
  dialog->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  story.perform("servo.check");
  EXPECT_NE(story.window().findChild<CheckDialog*>(), nullptr) << "it opens again";
}

}  // namespace underact::gui::test
