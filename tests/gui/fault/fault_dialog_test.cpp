#include "app/gui/fault/fault_dialog.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QListWidget>
#include <QPushButton>

#include "app/gui/fault/fault_watch.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow faultFeature();
}

namespace underact::gui::test {
namespace {

ShownFault shownFault(const char* what, const QString& path) {
  ShownFault told;
  told.words = {"no_sample", what, "Press Start."};
  told.when = "19:56:47";
  told.path = path;
  return told;
}

}  // namespace

TEST(FaultDialog, TellsTheLastAndListsThemOnceThereAreSeveral) {
  FaultDialog dialog(nullptr);
  dialog.tell(shownFault("The arm stopped answering.", "/a.json"));
  const auto text = [&dialog](const char* part) {
    return dialog.findChild<QLabel*>(QString("dialog.fault.%1").arg(part))->text();
  };
  EXPECT_EQ(text("what"), QString("The arm stopped answering."));
  EXPECT_TRUE(dialog.findChild<QWidget*>("dialog.fault.list")->isHidden());
  dialog.tell(shownFault("The arm jumped.", "/b.json"));
  EXPECT_EQ(dialog.count(), 2);
  EXPECT_FALSE(dialog.findChild<QWidget*>("dialog.fault.list")->isHidden());
  EXPECT_EQ(text("what"), QString("The arm jumped."));
  EXPECT_TRUE(text("file").contains("/b.json"));
  dialog.findChild<QListWidget*>("dialog.fault.list")->setCurrentRow(0);
  EXPECT_EQ(text("what"), QString("The arm stopped answering."));
  dialog.findChild<QPushButton*>("dialog.fault.copy")->click();
  EXPECT_EQ(QApplication::clipboard()->text(), QString("/a.json"));
}

TEST(FaultDialog, OneWithoutAFileHasNothingToCopyAndARepeatedOneIsCounted) {
  FaultDialog dialog(nullptr);
  ShownFault lost = shownFault("Lost.", {});
  lost.not_kept = "The disk is full.";
  dialog.tell(lost);
  EXPECT_FALSE(dialog.findChild<QWidget*>("dialog.fault.copy")->isEnabled());
  EXPECT_TRUE(dialog.findChild<QLabel*>("dialog.fault.file")->text().contains("The disk is full."));
  dialog.tellAgain();
  EXPECT_TRUE(dialog.findChild<QLabel*>("dialog.fault.what")->text().endsWith("(2 times)"));
  EXPECT_EQ(dialog.count(), 1);
}

TEST(FaultWatch, WhereNoneWasThereIsNoneToShow) {
  Desk desk(faultFeature());
  EXPECT_FALSE(desk.perform("servo.fault"));
}

TEST(FaultWatch, AnExceptionInTheWindowLetsGoAtOnceAndIsToldWithItsWords) {
  Desk desk(faultFeature());
  desk.perform("session.start");
  desk.run(300);
  ASSERT_TRUE(desk.host().running());
  desk.listener<FaultWatch>().reportException("the shelf is empty");
  EXPECT_FALSE(desk.host().running());
  QCoreApplication::processEvents();
  EXPECT_TRUE(desk.label("dialog.fault.what").contains("the shelf is empty"));
}

}  // namespace underact::gui::test
