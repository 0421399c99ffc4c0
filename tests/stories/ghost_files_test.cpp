#include <gtest/gtest.h>

#include <QFile>
#include <QMessageBox>
#include <QPushButton>

#include "app/gui/model/player.h"
#include "app/gui/visitor/visitor_mode.h"
#include "core/record/recorder.h"
#include "tests/stories/ghost_desk.h"
#include "tests/stories/session_desk.h"

namespace underact::gui::test {

TEST(GhostFilesStory, ASceneWithFilesIsKnownAgain) {
  const QString path = temporaryFile("on_a_mesh.h5");
  Class story("02_sphere");
  ASSERT_TRUE(story.perform("scene.open", shippedScene("26_bumpy_sphere")));
  ASSERT_TRUE(waitFor([&] { return story.window().document().scene().title != "Sphere"; }));
  {
    auto recorder = record::Recorder::start(story.host(), path.toStdString(), {});
    ASSERT_TRUE(static_cast<bool>(recorder));
    story.run(500);
    ASSERT_TRUE(recorder.value()->stop().empty());
  }
  ASSERT_TRUE(story.perform("ghost.open", path));
  ASSERT_TRUE(waitFor([&] { return story.ghost().ghost().path == path.toStdString(); }));
  EXPECT_FALSE(story.ghost().isElsewhere());
}

TEST(GhostFilesStory, AFileThatIsNoSessionIsSaidAndNothingChanges) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("ghost.open", temporaryFile("broken.h5", "this is no session")));
  ASSERT_TRUE(waitFor([&] { return story.window().findChild<QMessageBox*>("dialog.session_problems") != nullptr; }));
  auto* box = story.find<QMessageBox>("dialog.session_problems");
  EXPECT_TRUE(box->text().contains("broken.h5"));
  EXPECT_FALSE(box->informativeText().isEmpty());
  box->close();
  EXPECT_FALSE(story.window().findChild<GhostHand*>()->isOpen());
  EXPECT_FALSE(story.find("ghost")->isVisible());
}

TEST(GhostFilesStory, ReportsDamageAndFollowsTheRest) {
  const QString path = temporaryFile("damaged.h5");
  QFile::remove(path);
  ASSERT_TRUE(QFile::copy(teacherSession(), path));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  ASSERT_TRUE(file.seek(file.size() * 6 / 10));
  file.write(QByteArray(2000, 'Z'));
  file.close();
  Class story("02_sphere", path);
  auto* box = story.find<QMessageBox>("dialog.session_problems");
  EXPECT_TRUE(box->text().endsWith("is damaged. You follow the part that could be read.")) << box->text().toStdString();
  box->close();
  story.run(250);
  EXPECT_EQ(story.state().phase, ghost::Phase::Going);
}

TEST(GhostFilesStory, ReadingCanBeCancelledAndNothingChanges) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("ghost.open", teacherSession()));
  ASSERT_TRUE(story.find("load.cancel")->isVisible());
  story.find<QPushButton>("load.cancel")->click();  // at once: before anybody looks at what was read
  story.settle(300);
  EXPECT_FALSE(story.window().findChild<GhostHand*>()->isOpen());
  EXPECT_EQ(story.window().findChild<QMessageBox*>("dialog.session_problems"), nullptr);
}

TEST(GhostFilesStory, AReplayAndAGhostAreNotThereTogether) {
  Class story;
  ASSERT_TRUE(story.perform("replay.open", teacherSession()));
  ASSERT_TRUE(waitFor([&] {
    story.window().frame();
    return story.window().player().isOpen();
  }));
  EXPECT_FALSE(story.ghost().isOpen());
  EXPECT_FALSE(story.perform("ghost.open", teacherSession()));
  auto* box = story.find<QMessageBox>("dialog.session_problems");
  EXPECT_TRUE(box->informativeText().contains("Close the replay first."));
  box->close();
  ASSERT_TRUE(story.perform("replay.close"));
  EXPECT_TRUE(story.perform("ghost.open", teacherSession()));
}

TEST(GhostFilesStory, VisitorsFollowNobody) {
  Class story;
  ASSERT_TRUE(story.perform("visitor.start", QStringList{shippedScene("02_sphere")}));
  story.run(100);
  EXPECT_FALSE(story.ghost().isOpen());
  story.window().findChild<VisitorMode*>()->leave();
}

TEST(GhostFilesStory, ASessionOfTheListIsFollowedByItsMenu) {
  Desk desk;
  const QString path = desk.session(400, "by the teacher");
  ASSERT_TRUE(desk.listed(1));
  ASSERT_TRUE(desk.choose(path));
  ASSERT_TRUE(desk.story->perform("sessions.follow"));
  ASSERT_TRUE(waitFor([&] { return desk.story->window().findChild<GhostHand*>()->isOpen(); }));
  EXPECT_EQ(desk.story->window().findChild<GhostHand*>()->ghost().name, "by the teacher");
}

}  // namespace underact::gui::test
