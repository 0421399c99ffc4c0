#include <gtest/gtest.h>

#include <QFile>

#include "tests/stories/registration_desk.h"

namespace underact::gui::test {

TEST(RegistrationSheetStory, TheWizardSavesItAndSaysWhere) {
  RegistrationDesk desk;
  const QString path = temporaryFile("wizard_sheet.pdf");
  ASSERT_TRUE(desk.story.perform("registration.sheet", path));
  EXPECT_TRUE(desk.text("registration.layout").contains(path));
  EXPECT_TRUE(QFile::exists(path));
  EXPECT_FALSE(desk.story.perform("registration.sheet", QString("/nowhere/sheet.pdf")));
  EXPECT_TRUE(desk.text("registration.layout").contains("cannot be written"));
}

}  // namespace underact::gui::test
