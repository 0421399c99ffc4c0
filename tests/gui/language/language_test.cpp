#include "app/gui/model/language.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QPushButton>
#include <QTest>
#include <utility>

#include "app/gui/kit/restart.h"
#include "app/gui/language/language_actions.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow languageFeature();
}

namespace underact::gui::test {

TEST(LanguageActions, OneIsChosenAtATimeIsRememberedAndIsSaidToComeLater) {
  Desk desk(languageFeature());
  ASSERT_EQ(chosenLanguage(), QString("system"));
  EXPECT_TRUE(desk.actions().find("language.system")->isChecked());
  ASSERT_TRUE(desk.perform("language.de"));
  EXPECT_EQ(chosenLanguage(), QString("de"));
  EXPECT_TRUE(desk.actions().find("language.de")->isChecked());
  EXPECT_FALSE(desk.actions().find("language.system")->isChecked());
  auto* told = desk.find("dialog.language");
  ASSERT_NE(told, nullptr);
  EXPECT_TRUE(told->isVisible());
  delete told;
  ASSERT_TRUE(desk.perform("language.de"));
  EXPECT_EQ(desk.window().findChild<QWidget*>("dialog.language"), nullptr) << "nothing has changed";
  chooseLanguage("system");
}

TEST(LanguageActions, RestartNowClosesTheWindowAndStartsTheProgramOnce) {
  int starts = 0;
  const auto before = std::exchange(programStarter(), [&starts] { ++starts; });
  Desk desk(languageFeature());
  ASSERT_TRUE(desk.perform("language.de"));
  auto* now = desk.find<QPushButton>("dialog.language.restart");
  ASSERT_NE(now, nullptr);
  now->click();
  EXPECT_TRUE(QTest::qWaitFor([&starts] { return starts > 0; }));
  EXPECT_EQ(starts, 1);
  EXPECT_FALSE(desk.window().isVisible());
  programStarter() = before;
  chooseLanguage("system");
}

TEST(LanguageActions, ALanguageHasItsOwnNameInEveryLanguage) {
  Desk desk(languageFeature());
  EXPECT_EQ(desk.actions().find("language.de")->text().remove('&'), QString("Deutsch"));
  EXPECT_EQ(desk.actions().find("language.en")->text().remove('&'), QString("English"));
}

}  // namespace underact::gui::test
