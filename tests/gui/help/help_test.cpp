#include <gtest/gtest.h>
#include <underact/version.h>

#include <QTextBrowser>

#include "app/gui/help/help_dialog.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow helpFeature();
}

namespace underact::gui::test {

TEST(HelpDialog, ListsEveryShortcutWithWhatItDoesAlsoOfAnActionThatCameLater) {
  Desk desk(helpFeature());
  desk.actions().add({"test.bark", "Bark", QKeySequence("Ctrl+Alt+F12"), "Barks <once>."},
                     [](const QVariantList&) { return true; });
  desk.actions().add({"test.mute", "Mute", {}, "Is silent."}, [](const QVariantList&) { return true; });
  const HelpDialog dialog(desk.actions(), nullptr);
  const QString text = dialog.findChild<QTextBrowser*>("dialog.help.page")->toPlainText();
  EXPECT_TRUE(text.contains("Ctrl+Alt+F12") && text.contains("Barks <once>."));
  EXPECT_FALSE(text.contains("Is silent.")) << "it has no key";
  EXPECT_TRUE(text.contains("Starts the servo") || text.contains("F5"));
}

TEST(AboutDialog, SaysTheVersionAndThatNoRealArmWasTried) {
  const AboutDialog dialog(nullptr);
  const QString text = dialog.findChild<QLabel*>("dialog.about.text")->text();
  EXPECT_TRUE(text.contains(QString("Underact %1").arg(kVersion)));
  EXPECT_TRUE(text.contains("no part of it has been tested on a real arm"));
}

TEST(HelpActions, EachOpensItsDialog) {
  Desk desk(helpFeature());
  ASSERT_TRUE(desk.perform("help.keys"));
  EXPECT_TRUE(desk.find("dialog.help")->isVisible());
  ASSERT_TRUE(desk.perform("help.about"));
  EXPECT_TRUE(desk.find("dialog.about")->isVisible());
}

}  // namespace underact::gui::test
