#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <cmath>

#include "tests/stories/picture_difference.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

// A hand that pushes a little, the servo running and everything at rest: the same picture every time.
void push(Story& story, const Vec3& p_W) {
  sim::HandSetpoint setpoint;
  setpoint.p_WT = p_W;
  story.arm().setSetpoint(setpoint);
  story.perform("session.start");
  story.run(3000);
}

// A hand that feels its way over the ball for 10 s.
void feelTheBall(Story& story) {
  for (int step = 0; step < 40; ++step) {
    sim::HandSetpoint setpoint;
    const double a = 0.16 * step;
    setpoint.p_WT = Vec3(0.030 * std::sin(a), 0.022 * std::cos(0.7 * a), 0.036 + 0.008 * std::sin(2.1 * a));
    story.arm().setSetpoint(setpoint);
    story.run(250);
  }
  story.view().setHint({});
  story.settle(400);
}

}  // namespace

TEST(PicturesStory, EachShippedSceneLooksAsItDid) {
  for (const char* name : {"01_point", "02_sphere", "03_line", "04_plane", "05_circle", "06_cylinder", "07_box_outside",
                           "08_box_inside", "09_wall", "10_two_spheres_nearest"}) {
    Story story(name);
    story.perform("view.theme.light");
    push(story, {0.012, 0.018, 0.034});
    EXPECT_LT(story.imageDifference(name), kTolerance) << name;
  }
}

TEST(PicturesStory, TheDarkViewLooksAsItDid) {
  Story story("02_sphere");
  story.perform("view.theme.dark");
  push(story, {0.012, 0.018, 0.034});
  EXPECT_LT(story.imageDifference("sphere_dark"), kTolerance);
}

TEST(PicturesStory, APictureWithoutTheForceIsNotTheSame) {  // the comparison sees what matters
  Story story("02_sphere");
  story.perform("view.theme.light");
  push(story, {0.012, 0.018, 0.034});
  story.view().setFixedSize(640, 480);
  story.settle(300);
  const QImage with = story.view().picture();
  story.perform("layer.force", false);
  story.settle();
  EXPECT_GT(worstBlockDifference(with, story.view().picture()), 2.0 * kTolerance);
}

TEST(PicturesStory, TheWindowForTheReadme) {
  Story story("02_sphere", {.servo = {.clock = servo::Clock::Thread}});  // so that its status line is a real one
  story.perform("dock.plots", true);
  story.perform("session.start");
  feelTheBall(story);
  for (const char* theme : {"light", "dark"}) {
    story.perform(QString("view.theme.") + theme);
    story.savePicture(QString("window_") + theme);
  }
}

// To be looked at by people, too: what is said when something is not well.
TEST(PicturesStory, TheDialogsAndTheWarnings) {
  const QString folder = QString(UNDERACT_BINARY) + "/pictures";
  QDir().mkpath(folder);
  Story story("05_circle");
  story.perform("scene.open", temporaryFile("typos.json", R"({
  "underact_scene": 1, "title": "Typos", "arm": "omny",
  "control": {"law": "PX", "kp_N_per_mm": -1},
  "constraints": [{"type": "sphere", "center_mm": [0, 0], "radius": 5}, {"type": "plain"}]
})"));
  story.settle(200);
  EXPECT_TRUE(story.find("dialog.problems")->grab().save(folder + "/dialog_problems.png"));
  story.perform("help.keys");
  story.perform("help.about");
  story.settle(200);
  EXPECT_TRUE(story.find("dialog.help")->grab().save(folder + "/dialog_help.png"));
  EXPECT_TRUE(story.find("dialog.about")->grab().save(folder + "/dialog_about.png"));
  story.window().findChild<QCheckBox*>("panel.feel.link")->setChecked(false);
  story.perform("gains.set", "kp", "x", 3.2);
  story.perform("gains.set", "kp", "y", 0.0);
  story.settle(200);
  EXPECT_TRUE(story.find<QLabel>("panel.feel.refusal")->isVisible());
  EXPECT_TRUE(story.picture().save(folder + "/window_warnings.png"));
}

TEST(PicturesStory, TextOfTwiceTheSizeIsNotCut) {
  const QFont default_value = QApplication::font();
  QFont large = default_value;
  large.setPointSizeF(2.0 * default_value.pointSizeF());
  QApplication::setFont(large);
  {
    Story story("12_line_pid", {.size = {1920, 1080}});
    for (const char* name : {"panel.gains.kp.x.number", "panel.gains.ki.x.number", "button.session.stop",
                             "status.force", "panel.feel.law", "panel.scenes.filter"}) {
      const QWidget* widget = story.find(name);
      EXPECT_GE(widget->height(), widget->minimumSizeHint().height()) << name;
      EXPECT_GE(widget->height(), QFontMetrics(large).height()) << name;
    }
    EXPECT_TRUE(story.picture().save(QString(UNDERACT_BINARY) + "/pictures/window_large_text.png"));
  }
  QApplication::setFont(default_value);
}

// To be looked at by people: build/.../pictures/window_WIDTH_THEME.png.
TEST(PicturesStory, TheWindowAtEverySize) {
  for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1920, 1080)}) {
    Story story(size.width() == 1024 ? "12_line_pid" : "02_sphere", {.size = size});
    story.perform("session.start");
    feelTheBall(story);
    const QString folder = QString(UNDERACT_BINARY) + "/pictures";
    QDir().mkpath(folder);
    for (const char* theme : {"light", "dark"}) {
      story.perform(QString("view.theme.") + theme);
      EXPECT_TRUE(story.picture().save(QString("%1/window_%2_%3.png").arg(folder).arg(size.width()).arg(theme)));
    }
  }
}

}  // namespace underact::gui::test
