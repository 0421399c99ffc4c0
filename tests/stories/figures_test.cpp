#include <gtest/gtest.h>

#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>

#include "app/gui/gallery/figure_picture.h"
#include "app/gui/gallery/figures_run.h"
#include "app/gui/gallery/gallery_dialog.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

constexpr int kMake_ms = 180'000;  // some seconds of it are Python's own beginning; another process may have the core

/// A variable of the environment for as long as this lives.
class Surroundings {
 public:
  Surroundings(const char* name, const QByteArray& value)
      : name_(name), before_(qgetenv(name)), was_set_(qEnvironmentVariableIsSet(name)) {
    qputenv(name, value);
  }
  ~Surroundings() { was_set_ ? qputenv(name_, before_) : qunsetenv(name_); }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

 private:
  const char* name_;
  QByteArray before_;
  bool was_set_;
};

/// A window with the gallery open over a folder that holds what is given, and nothing else.
class Gallery {
 public:
  explicit Gallery(const QString& only, const QByteArray& figures = {}) {
    QDir(figureFolder()).removeRecursively();
    if (!figures.isEmpty()) {
      QDir().mkpath(figureFolder());
      QFile file(figureFolder() + "/figures.json");
      EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(figures) > 0);
    }
    open(only);
  }
  void open(const QString& only) {
    story.perform("help.figures", only);
    dialog = story.window().findChild<GalleryDialog*>();
    list = dialog->findChild<QListWidget*>();
    story.bringToFront(dialog);
  }
  void close() {
    dialog->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  void click(const char* name) { story.find<QPushButton>(QString("dialog.figures.") + name)->click(); }
  bool make() {
    click("make");
    return QTest::qWaitFor([this] { return !dialog->isMaking(); }, kMake_ms);
  }

  Story story{"02_sphere"};
  GalleryDialog* dialog = nullptr;
  QListWidget* list = nullptr;
};

/// How much of a picture is not white, 0 to 1.
double inkOf(const QImage& image) {
  int dark = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) dark += qGray(image.pixel(x, y)) < 230 ? 1 : 0;
  }
  return static_cast<double>(dark) / (image.width() * image.height());
}

constexpr const char* kOneThatFails = R"([{"figure": "4.2", "title": "Results", "caption": "Words.", "kind": "run",
  "pictures": [], "left_out": "", "problem": "", "scene": "", "hand": "", "session": "", "passed": false, "numbers": [
    {"what": "slope", "measured": -0.4, "expected": -0.5, "tolerance": 0.001, "unit": "N/mm", "passed": false},
    {"what": "turn", "measured": null, "expected": 0, "tolerance": 1, "unit": "deg", "passed": false},
    {"what": "force", "measured": 0.88, "expected": 0.88, "tolerance": 1e-9, "unit": "N", "passed": true}]}])";

}  // namespace

TEST(FiguresStory, AreMadeSeenCheckedFeltAndKept) {
  Gallery gallery("4.5,B.1");
  GalleryDialog& dialog = *gallery.dialog;
  EXPECT_FALSE(dialog.isModal()) << "Esc must stop the arm, whatever is open";
  EXPECT_TRUE(dialog.message().startsWith("The figures are not made yet."));
  EXPECT_FALSE(gallery.story.find("dialog.figures.page")->isEnabled());
  EXPECT_TRUE(dialog.grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/dialog_figures_none.png"));
  ASSERT_TRUE(gallery.make());
  EXPECT_TRUE(dialog.message().startsWith("2 figures, ")) << dialog.message().toStdString();
  EXPECT_TRUE(dialog.message().contains("all as they should be."));
  ASSERT_EQ(gallery.list->count(), 2);
  EXPECT_TRUE(gallery.list->item(0)->text().startsWith("4.5  Results of the sphere constraint"));
  EXPECT_TRUE(gallery.list->item(0)->text().contains("numbers pass"));
  gallery.story.settle(200);
  auto* picture = dialog.findChild<FigurePicture*>();
  EXPECT_TRUE(picture->hasPicture());
  EXPECT_GT(inkOf(picture->grab().toImage().convertToFormat(QImage::Format_RGB32)), 0.02);
  for (int index = 0; index < 2; ++index) {
    const QImage thumbnail = gallery.list->item(index)->icon().pixmap(gallery.list->iconSize()).toImage();
    EXPECT_GT(inkOf(thumbnail.convertToFormat(QImage::Format_RGB32)), 0.01);
  }
  EXPECT_TRUE(dialog.grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/dialog_figures.png"));
  auto* numbers = dialog.findChild<QTableWidget*>();
  ASSERT_GE(numbers->rowCount(), 3);
  for (int row = 0; row < numbers->rowCount(); ++row) EXPECT_EQ(numbers->item(row, 5)->text(), "✓ pass") << row;

  const QString pdf = temporaryFile("figure.pdf");
  dialog.savePdf(pdf);
  QFile saved(pdf);
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  EXPECT_TRUE(saved.readAll().startsWith("%PDF"));

  gallery.click("scene");
  EXPECT_EQ(gallery.story.window().document().path(), figureFolder() + "/scenes/sphere.json");
  gallery.story.run(10);
  EXPECT_EQ(gallery.story.host().scene().constraints.size(), 1U);

  gallery.list->setFocus();
  gallery.story.bringToFront(&dialog);
  gallery.story.key(Qt::Key_Down);
  EXPECT_TRUE(gallery.story.find<QLabel>("dialog.figures.title")->text().startsWith("Figure B.1: "));
  EXPECT_FALSE(gallery.story.find("dialog.figures.scene")->isEnabled()) << "a step response has no scene";

  gallery.close();
  gallery.open({});
  EXPECT_EQ(gallery.list->count(), 2) << "they are kept";
  EXPECT_FALSE(gallery.dialog->isMaking());
}

TEST(FiguresStory, AFigureThatShowsSomethingElseIsSaidInWords) {
  Gallery gallery({}, kOneThatFails);
  EXPECT_TRUE(gallery.list->item(0)->text().endsWith("2 of 3 numbers fail"));
  auto* numbers = gallery.dialog->findChild<QTableWidget*>();
  ASSERT_EQ(numbers->rowCount(), 3);
  EXPECT_EQ(numbers->item(0, 5)->text(), "✗ fail");
  EXPECT_EQ(numbers->item(0, 1)->text(), "−0.4");
  EXPECT_EQ(numbers->item(1, 1)->text(), "none");
  EXPECT_EQ(numbers->item(2, 5)->text(), "✓ pass");
  EXPECT_TRUE(gallery.dialog->message().contains("2 not as they should be."));
  EXPECT_TRUE(gallery.dialog->message().contains("make them again")) << "nobody knows which version made them";
  EXPECT_FALSE(gallery.story.find("dialog.figures.pdf")->isEnabled());
}

TEST(FiguresStory, AMissingPythonIsToldWithTheWayOutAndTheOldFiguresStay) {
  const Surroundings python("UNDERACT_PYTHON", "/dev/null/nowhere");
  Gallery gallery("B.1", kOneThatFails);
  ASSERT_TRUE(gallery.make());
  EXPECT_TRUE(gallery.dialog->message().contains("Python could not be started"))
      << gallery.dialog->message().toStdString();
  EXPECT_TRUE(gallery.dialog->message().contains("Install python3, python3-h5py and python3-matplotlib"));
  EXPECT_EQ(gallery.list->count(), 1);
  gallery.story.settle();
  EXPECT_TRUE(
      gallery.dialog->grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/dialog_figures_no_python.png"));
}

TEST(FiguresStory, AMissingProgramIsTold) {
  Gallery gallery("B.1");
  const Surroundings cli("UNDERACT_CLI", "/dev/null/nowhere/underact-cli");
  ASSERT_TRUE(gallery.make());
  EXPECT_TRUE(gallery.dialog->message().contains(
      "underact-cli was not found. Searched: /dev/null/nowhere/underact-cli. Install Underact again."))
      << gallery.dialog->message().toStdString();
}

TEST(FiguresStory, CancelEndsItAndTheOldFiguresStay) {
  Gallery gallery({}, kOneThatFails);
  gallery.click("make");
  auto* progress = gallery.dialog->findChild<QProgressBar*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return progress->maximum() > 2; }, kMake_ms)) << "it says how many there are";
  gallery.story.settle();
  EXPECT_TRUE(gallery.dialog->grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/dialog_figures_making.png"));
  EXPECT_TRUE(progress->format().startsWith("figure ")) << progress->format().toStdString();
  gallery.click("make");  // Cancel, now
  EXPECT_FALSE(gallery.dialog->isMaking());
  EXPECT_TRUE(gallery.dialog->message().startsWith("Cancelled"));
  EXPECT_EQ(gallery.list->count(), 1);
  EXPECT_FALSE(QDir(figureFolder() + ".making").exists());
}

TEST(FiguresStory, CancelEndsWhatTheProgramHasStarted) {
  const QString mark = temporaryFile("went_on");
  const QString program = temporaryFile("slow-cli", R"(#!/bin/sh
echo '{"number": 1, "of": 3, "figure": "4.2"}' >&2
(sleep 1; touch ")" + mark.toUtf8() + R"(") &
wait
)");
  QFile::setPermissions(program, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  Gallery gallery({});
  const Surroundings cli("UNDERACT_CLI", program.toUtf8());
  gallery.click("make");
  auto* progress = gallery.dialog->findChild<QProgressBar*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return progress->maximum() == 3; }, 10'000));
  EXPECT_EQ(progress->format(), "figure 4.2 (1 of 3)");
  gallery.click("make");  // Cancel
  QTest::qWait(1500);
  EXPECT_FALSE(QFile::exists(mark));
}

TEST(FiguresStory, ClosingTheGalleryEndsTheMaking) {
  Gallery gallery({});
  gallery.click("make");
  auto* progress = gallery.dialog->findChild<QProgressBar*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return progress->maximum() > 2; }, kMake_ms));
  gallery.close();
  EXPECT_FALSE(QDir(figureFolder() + ".making").exists());
  gallery.open({});
  EXPECT_TRUE(gallery.dialog->message().startsWith("The figures are not made yet."));
}

TEST(FiguresStory, TheSessionOpensWhereTheWindowCanReplayOne) {
  QDir(figureFolder()).removeRecursively();
  QDir().mkpath(figureFolder());
  QFile file(figureFolder() + "/figures.json");
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray(kOneThatFails).replace(R"("session": "")", R"("session": "sessions/point.h5")"));
  file.close();
  QString opened;
  GalleryDialog with({[](const QString&) {}, [&opened](const QString& path) { opened = path; }}, {}, nullptr);
  auto* button = with.findChild<QPushButton*>("dialog.figures.session");
  EXPECT_TRUE(button->isVisibleTo(&with));
  button->click();
  EXPECT_EQ(opened, figureFolder() + "/sessions/point.h5");
  const GalleryDialog without({[](const QString&) {}, {}}, {}, nullptr);
  EXPECT_FALSE(without.findChild<QPushButton*>("dialog.figures.session")->isVisibleTo(&without));
}

}  // namespace underact::gui::test
