// Meshes where no dialog asks: a picture from the command line, a replay.
#include <gtest/gtest.h>

#include <QFileInfo>
#include <QProcess>
#include <algorithm>

#include "app/gui/model/player.h"
#include "core/record/recorder.h"
#include "tests/stories/mesh_desk.h"

namespace underact::gui::test {
namespace {

QString ballScene() {
  static const QString kPath = [] {
    const QString mesh = temporaryFile("replayed.stl", ballStl(30.0, Vec3::Zero(), 48, 24));
    const QString text = R"({"underact_scene": 1, "title": "Ball", "constraints": [
      {"type": "mesh", "file": "%1", "side": "outside", "friction": {"static": 0.3, "dynamic": 0.2}}]})";
    return temporaryFile("ball_scene.json", text.arg(QFileInfo(mesh).fileName()).toUtf8());
  }();
  return kPath;
}

}  // namespace

TEST(MeshElsewhereStory, TheProgramDrawsAPictureOfAMesh) {
  QProcess program;
  const QString out = temporaryFile("mesh_picture.png");
  program.start(UNDERACT_WINDOW, {"--picture", ballScene(), "--out", out});
  ASSERT_TRUE(program.waitForFinished(60000));
  EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
  const QImage picture(out);
  int blue = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QColor c = picture.pixelColor(x, y);
      if (c.blue() - c.red() > 40) ++blue;
    }
  }
  EXPECT_GT(blue, picture.width() * picture.height() / 50);  // the ball is a fifth as high as the picture
}

TEST(MeshElsewhereStory, ASessionWithAMeshIsReplayedWithIt) {
  const QString session = temporaryFile("mesh_session.h5");
  {
    Story story("02_sphere");
    ASSERT_TRUE(story.perform("scene.open", ballScene()));
    ASSERT_TRUE(waitForMeshes(story));
    handTo(story, {0.0, 0.0, 0.045});
    story.perform("session.start");
    story.run(1000);  // the ramp
    auto recorder = record::Recorder::start(story.host(), session.toStdString(), {.name = "Ball"});
    ASSERT_TRUE(recorder);
    handTo(story, {0.002, 0.001, 0.0285});
    ASSERT_TRUE(recorder.value()->stop().empty());
    ASSERT_GT(story.force_N(), 0.05);
  }
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("replay.open", session));
  ASSERT_TRUE(QTest::qWaitFor([&] {
    story.window().frame();
    return story.window().player().isOpen() && !story.window().player().isLoading();
  }));
  EXPECT_NE(meshOf(story).surface, nullptr);
  EXPECT_GT(story.view().trianglesDrawn(), 0U);
  story.run(1000);  // the ramp
  ASSERT_TRUE(story.perform("replay.play"));
  Player& player = story.window().player();
  double greatest_N = 0.0;
  for (int step = 0; step < 18; ++step) {
    story.run(100);
    const device::RecordedRow& row = player.recorded().rows[static_cast<std::size_t>(player.row())];
    EXPECT_NEAR(story.force_N(), static_cast<double>(row.force_N), 1e-5);  // a float's rounding
    greatest_N = std::max(greatest_N, story.force_N());
  }
  EXPECT_GT(greatest_N, 0.05);
  // What if it were smooth? An edit of it has its surface, too.
  ASSERT_TRUE(story.perform("friction.on", false));
  EXPECT_NE(meshOf(story).surface, nullptr);
}

}  // namespace underact::gui::test
