#include "app/gui/palette/palette.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTest>
#include <set>

#include "app/gui/palette/words.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow paletteFeature();
}

namespace underact::gui::test {
namespace {

struct PaletteDesk : Desk {
  PaletteDesk() : Desk(paletteFeature()) {
    perform("help.find");
    words = find<QLineEdit>("palette.words");
    list = find<QListWidget>("palette.list");
  }
  QLineEdit* words;
  QListWidget* list;
};

}  // namespace

TEST(PaletteWords, FitWhereEachTypedWordBeginsAWordOfSomeText) {
  const QStringList texts{"undo", "undoes the last change", "ruckgangig machen"};
  EXPECT_GT(fitOf("und", texts), fitOf("last", texts)) << "the name counts more than what explains it";
  EXPECT_GT(fitOf("last change", texts), 0);
  EXPECT_GT(fitOf("Rückg", texts), 0) << "without accents";
  EXPECT_EQ(fitOf("ndo", texts), 0) << "inside a word";
  EXPECT_EQ(fitOf("undo nothing", texts), 0);
  EXPECT_GT(fitOf("", texts), 0) << "everything, before anything is typed";
  EXPECT_EQ(searchText("Save &report…  (ÄÖ)"), QString("save report ao"));
}

TEST(PaletteWords, KnowTheWindowsTextsInItsOtherLanguage) {
  const QMultiHash<QString, QString> others = otherLanguages();
  EXPECT_TRUE(others.values("undo").contains("ruckgangig")) << others.values("undo").join(", ").toStdString();
  EXPECT_TRUE(others.values("ruckgangig").contains("undo"));
}

TEST(Palette, FindsCommandsInBothLanguagesAndDoesTheFirst) {
  PaletteDesk desk;
  int barks = 0;
  desk.actions().add({"test.bark", "&Bark loudly", {}, "Makes a noise."}, [&barks](const QVariantList&) {
    ++barks;
    return true;
  });
  desk.find("dialog.palette")->close();
  desk.perform("help.find");
  auto* const palette = desk.window().findChildren<Palette*>().last();
  auto* const words = palette->findChild<QLineEdit*>();
  words->setText("noise bark");
  ASSERT_EQ(palette->findChild<QListWidget*>()->count(), 1);
  QTest::keyClick(words, Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&barks] { return barks == 1; }));
  EXPECT_TRUE(palette->isHidden());
}

TEST(Palette, SaysWhatIsNotThereAndWhatIsNotPossibleNow) {
  PaletteDesk desk;
  desk.words->setText("xyzzy");
  EXPECT_EQ(desk.list->count(), 0);
  EXPECT_TRUE(desk.label("palette.note").startsWith("Nothing found."));
  desk.actions().find("edit.undo")->setEnabled(false);
  desk.words->setText("undo");
  ASSERT_GT(desk.list->count(), 0);
  QTest::keyClick(desk.words, Qt::Key_Return);
  EXPECT_TRUE(desk.label("palette.note").contains("not possible now"));
  EXPECT_FALSE(desk.find("dialog.palette")->isHidden());
}

TEST(Palette, ArrowKeysMoveInTheListWhileWordsAreTyped) {
  PaletteDesk desk;
  desk.words->setText("s");
  ASSERT_GT(desk.list->count(), 2);
  QTest::keyClick(desk.words, Qt::Key_Down);
  QTest::keyClick(desk.words, Qt::Key_Down);
  QTest::keyClick(desk.words, Qt::Key_Up);
  EXPECT_EQ(desk.list->currentRow(), 1);
  QTest::keyClick(desk.words, Qt::Key_PageUp);
  EXPECT_EQ(desk.list->currentRow(), 0);
}

TEST(Palette, OffersWhatFeaturesNameAndShowsAtMostSixty) {
  PaletteDesk desk;
  desk.find("dialog.palette")->close();
  desk.actions().addChoices([] {
    std::vector<Choice> many;
    for (int number = 0; number < 100; ++number) many.push_back({QString("Zebra %1").arg(number), "Animal", "a", "b"});
    return many;
  });
  const std::vector<PaletteEntry> entries = paletteEntries(desk.actions(), desk.window());
  EXPECT_EQ(fitting(entries, "zebra").size(), 100U);
  EXPECT_EQ(fitting(entries, "animal zebra 42").size(), 1U);
  Palette palette(entries, &desk.window());
  palette.findChild<QLineEdit*>()->setText("zebra");
  EXPECT_EQ(palette.findChild<QListWidget*>()->count(), 60);
}

}  // namespace underact::gui::test
