#include <gtest/gtest.h>

#include <QProcess>
#include <QScreen>

#include "tests/stories/story.h"
#include "tests/stories/titles_on_screen.h"

// What makes the window look finished, on the screen.
namespace underact::gui::test {
namespace {

/// Of the rows in which a mesh's blue begins, those with a tone between the ground's and its own.
double smoothShare(const QImage& picture) {
  int begins = 0, smooth = 0;
  const auto blueness = [&](int x, int y) { return qBlue(picture.pixel(x, y)) - qRed(picture.pixel(x, y)); };
  for (int y = picture.height() / 4; y < picture.height(); ++y) {
    for (int x = 2; x + 2 < picture.width(); ++x) {
      const int inside = blueness(x + 2, y), here = blueness(x + 1, y);
      if (blueness(x, y) > 4 || inside < 60 || std::abs(here - inside) > 0.9 * inside) continue;
      const bool between = here > 0.12 * inside && here < 0.88 * inside;
      ++begins;
      smooth += between ? 1 : 0;
      break;
    }
  }
  return begins < 30 ? 0.0 : static_cast<double>(smooth) / begins;
}

}  // namespace

TEST(FinishStory, TheSilhouetteOfAMeshIsSmoothOnTheScreenAtRest) {
  Story story("26_bumpy_sphere");
  story.perform("view.theme.light");
  story.perform("layer.arm", false);
  story.settle(900);
  const QImage screen = story.view().screen()->grabWindow(story.view().window()->winId()).toImage();
  const QPoint corner = story.view().mapTo(story.view().window(), QPoint());
  EXPECT_GT(smoothShare(screen.copy(QRect(corner, story.view().size()))), 0.6);
}

TEST(FinishStory, TitlesHaveOneDashAndItIsNotAddedByQt) {
  for (const char* const language : {"en", "de"}) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LANGUAGE", language);
    environment.insert("LC_ALL", QString(language) == "de" ? "de_DE.UTF-8" : "C.UTF-8");
    environment.insert("XDG_CONFIG_HOME", temporaryFile(QString("titles_") + language));
    program.setProcessEnvironment(environment);
    program.start(UNDERACT_WINDOW, {temporaryFile("titles.json", R"({"underact_scene": 1, "arm": "omny"})")});
    QStringList titles;
    const bool is_told = QTest::qWaitFor(
        [&] {
          return (titles = TitlesOnScreen::read()).join(' ').contains("cene not") || titles.join(' ').contains("nicht");
        },
        20000);
    EXPECT_TRUE(is_told) << titles.join("; ").toStdString();
    for (const QString& title : titles)
      EXPECT_FALSE(title.contains(QChar(0x2014)) || title.contains(" - ")) << title.toStdString();
    program.kill();
    program.waitForFinished();
  }
}

}  // namespace underact::gui::test
