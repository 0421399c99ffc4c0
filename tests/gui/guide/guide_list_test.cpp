#include "app/gui/guide/guide_list.h"

#include <gtest/gtest.h>

#include <QListWidget>
#include <QSignalSpy>
#include <QTreeWidget>

#include "app/gui/guide/guide_window.h"
#include "tests/gui/guide_pages.h"

namespace underact::gui::test {

TEST(GuideList, HitsAreChosenUpAndDownWithinTheirEndsAndOpened) {
  GuideList list(theGuide(), nullptr);
  QSignalSpy chosen(&list, &GuideList::chosen);
  EXPECT_FALSE(list.openHit()) << "the contents are shown";
  guide::Hit one, other;
  one.page = "energy";
  one.page_title = "Energy";
  other.page = "servo";
  other.anchor = "hold-to-run";
  other.page_title = "Servo";
  other.title = "Hold to run";
  list.showHits({one, other}, true);
  ASSERT_TRUE(list.openHit());
  EXPECT_EQ(chosen.last().first().toString(), QString("energy")) << "the first is chosen";
  list.moveHit(-1);
  list.moveHit(1);
  list.moveHit(5);
  ASSERT_TRUE(list.openHit());
  ASSERT_EQ(chosen.count(), 2);
  EXPECT_EQ(chosen.last().first().toString(), QString("servo#hold-to-run"));
  EXPECT_EQ(list.findChild<QListWidget*>()->item(1)->text(), QString("Servo – Hold to run"));
}

TEST(GuideList, WhereNothingWasFoundItSaysSoAndCannotBeOpened) {
  GuideList list(theGuide(), nullptr);
  QSignalSpy chosen(&list, &GuideList::chosen);
  list.showHits({}, true);
  EXPECT_EQ(list.findChild<QListWidget*>()->item(0)->text(), QString("Nothing was found."));
  list.openHit();
  EXPECT_EQ(chosen.count(), 0);
  list.showHits({}, false);
  EXPECT_EQ(list.currentWidget(), list.findChild<QTreeWidget*>());
}

TEST(GuideWindow, APageThatIsNotThereLeavesTheOneBefore) {
  GuideWindow window(theGuide(), 100, nullptr);
  EXPECT_EQ(window.place(), QString());
  ASSERT_TRUE(window.open("energy"));
  EXPECT_FALSE(window.open("no_such_page"));
  EXPECT_EQ(window.place(), QString("energy"));
  ASSERT_TRUE(window.open("servo#hold-to-run"));
  EXPECT_EQ(window.place(), QString("servo#hold-to-run"));
}

}  // namespace underact::gui::test
