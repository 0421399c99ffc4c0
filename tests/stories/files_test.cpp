#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>

#include "core/scene/read.h"
#include "core/scene/write.h"
#include "tests/stories/mesh_desk.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

constexpr const char* kBroken = R"({
  "underact_scene": 1,
  "title": "Broken",
  "constraints": [
    {"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": -5},
    {"type": "plain", "point_mm": [0, 0, 0]}
  ]
})";

void answer(QMessageBox::StandardButton button) {
  QTimer::singleShot(200, [button] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    QTest::mouseClick(box->button(button), Qt::LeftButton);
  });
}

/// Answers every question about edits while it lives, and counts them.
struct Discarding {
  Discarding() {
    QObject::connect(&looks, &QTimer::timeout, [this] {
      auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr || box->objectName() != "dialog.unsaved") return;
      ++asked;
      box->button(QMessageBox::Discard)->click();
    });
    looks.start(50);
  }
  QTimer looks;
  int asked = 0;
};

/// A scene file of the user's own.
QString ownScene(const QString& of) {
  QFile file(shippedScene(of));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  return temporaryFile("own_" + of + ".json", file.readAll());
}

double stiffness(Story& story) {
  return story.host().scene().control.gains.kp_N_per_mm.x();
}

}  // namespace

TEST(FilesStory, WhoDiscardsEditsIsAskedOnceWhenTheWindowClosesAndWhenASceneWithAMeshOpens) {
  {
    Story story(ownScene("02_sphere"));
    story.perform("gains.set", "kp", "x", 0.7);
    Discarding discarding;
    EXPECT_TRUE(story.perform("app.quit"));
    EXPECT_EQ(discarding.asked, 1);
  }
  Story story(ownScene("02_sphere"));
  story.perform("gains.set", "kp", "x", 0.7);
  Discarding discarding;
  EXPECT_TRUE(story.perform("scene.open", shippedScene("27_bracket")));
  ASSERT_TRUE(waitForMeshes(story));
  EXPECT_TRUE(story.window().document().path().endsWith("27_bracket.json"));
  EXPECT_EQ(discarding.asked, 1);
}

TEST(FilesStory, AShippedSceneThatWasTunedAsksNothingAndIsTunedTheNextTimeUntilReset) {
  Discarding discarding;
  {
    Story story("02_sphere");
    const double own = stiffness(story);
    story.perform("gains.set", "kp", "x", 0.7);
    ASSERT_TRUE(story.perform("scene.open", shippedScene("04_plane")));
    ASSERT_TRUE(story.perform("scene.open", shippedScene("02_sphere")));
    EXPECT_DOUBLE_EQ(stiffness(story), 0.7);
    EXPECT_TRUE(story.find<QLabel>("notice.sentence")->text().contains("Undo"));
    ASSERT_TRUE(story.perform("edit.undo"));
    EXPECT_DOUBLE_EQ(stiffness(story), own);
    ASSERT_TRUE(story.perform("edit.redo"));
    ASSERT_TRUE(story.perform("gains.reset"));
    ASSERT_TRUE(story.perform("scene.open", shippedScene("04_plane")));
    ASSERT_TRUE(story.perform("scene.open", shippedScene("02_sphere")));
    EXPECT_DOUBLE_EQ(stiffness(story), own) << "it was reset";
    story.perform("gains.set", "kp", "x", 0.6);
    ASSERT_TRUE(story.perform("lesson.start", "07_stiffness"));
    ASSERT_TRUE(story.perform("lesson.leave"));
    EXPECT_DOUBLE_EQ(stiffness(story), 0.6);
    EXPECT_TRUE(story.perform("app.quit"));
  }
  Story again("02_sphere", {.first_start = false});
  EXPECT_DOUBLE_EQ(stiffness(again), 0.6);
  EXPECT_EQ(discarding.asked, 0);
}

TEST(FilesStory, ADroppedBrokenFileShowsAllProblemsAndTheSceneRunsOn) {
  Story story("02_sphere");
  story.perform("session.start");
  story.run(500);
  const std::uint64_t before = story.host().revision();
  drop(story, temporaryFile("broken.json", kBroken));
  auto* table = story.find<QTableWidget>("dialog.problems.table");
  ASSERT_TRUE(table->isVisible());
  EXPECT_GE(table->rowCount(), 2);
  EXPECT_EQ(table->item(0, 0)->text(), "5");
  EXPECT_FALSE(story.find("dialog.problems")->isModal());
  story.run(500);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  EXPECT_EQ(story.host().revision(), before);
  EXPECT_EQ(story.host().scene().title, "Sphere");
  QTest::mouseClick(story.find("dialog.problems.copy"), Qt::LeftButton);
  EXPECT_TRUE(QApplication::clipboard()->text().contains("broken.json:5:"));
  drop(story, shippedScene("04_plane"));
  EXPECT_FALSE(table->isVisible());  // the next file that opens takes the list away
}

TEST(FilesStory, SaveAsReadsBackToTheSameSceneAndIsRemembered) {
  const QString path = temporaryFile("tuned.json");
  Story story("05_circle");
  story.perform("gains.set", "kp", "x", 0.7);
  EXPECT_TRUE(story.window().isWindowModified());
  ASSERT_TRUE(story.perform("scene.save_as", path));
  EXPECT_FALSE(story.window().isWindowModified());
  const Result<scene::Description> read = scene::readSceneFile(path.toStdString());
  ASSERT_TRUE(read);
  EXPECT_EQ(scene::writeScene(read.value()), scene::writeScene(story.host().scene()));
  EXPECT_DOUBLE_EQ(read.value().control.gains.kp_N_per_mm.x(), 0.7);
  auto* recent = story.find<QMenu>("menu.recent");
  ASSERT_EQ(recent->actions().size(), 1);
  story.perform("scene.open", shippedScene("02_sphere"));
  recent->actions().first()->trigger();
  EXPECT_EQ(story.window().document().path(), path);
}

TEST(FilesStory, EditsAreAskedAboutBeforeTheyAreReplaced) {
  Story story(ownScene("02_sphere"));
  story.perform("gains.set", "kp", "x", 0.7);
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(story.perform("scene.open", shippedScene("04_plane")));
  EXPECT_EQ(story.host().scene().title, "Sphere");
  EXPECT_DOUBLE_EQ(story.host().scene().control.gains.kp_N_per_mm.x(), 0.7);
  answer(QMessageBox::Discard);
  EXPECT_TRUE(story.perform("scene.open", shippedScene("04_plane")));
  EXPECT_NE(story.host().scene().title, "Sphere");
}

}  // namespace underact::gui::test
