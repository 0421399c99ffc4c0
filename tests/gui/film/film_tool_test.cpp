#include "app/gui/film/film_tool.h"

#include <gtest/gtest.h>

#include <QMessageBox>
#include <QTest>

#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow filmFeature();
}

namespace underact::gui::test {

TEST(FilmTool, SaysWhyAFilmWasNotMade) {
  qputenv("UNDERACT_PROGRAM", "/bin/false");
  Desk desk(filmFeature());
  EXPECT_TRUE(desk.listener<FilmTool>().busyReason().isEmpty());
  ASSERT_TRUE(desk.perform("view.film", desk.fileOf("a.webm", "")));
  EXPECT_FALSE(desk.listener<FilmTool>().busyReason().isEmpty());
  ASSERT_TRUE(
      QTest::qWaitFor([&desk] { return desk.window().findChild<QWidget*>("dialog.film_problems") != nullptr; }));
  EXPECT_TRUE(desk.listener<FilmTool>().busyReason().isEmpty());
}

}  // namespace underact::gui::test
