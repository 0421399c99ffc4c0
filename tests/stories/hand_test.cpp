#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>

#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

constexpr double kBall_m = 0.050;
constexpr double kFriction_m =
    0.26 / 500.0;  // of the arm, over the stiffness of the scene: where a loose stylus sticks

/// A user's window: the hand lets go.
struct Loose {
  explicit Loose(const char* scene, bool first_start = true)
      : story(scene, {.first_start = first_start, .keeps_holding = false}) {
    story.perform("view.top");
    story.settle(400);
    story.perform("session.start");
    story.run(2000);
  }
  double away_m() { return story.snapshot().report.p_WT.norm(); }
  Story story;
};

int runCli(const QStringList& arguments) {
  return QProcess::execute(QString::fromLocal8Bit(qgetenv("UNDERACT_CLI")), arguments);
}

}  // namespace

TEST(HandStory, DraggingTheStylusIntoTheSphereRaisesTheForce) {
  Story story("02_sphere");
  story.perform("view.top");  // z of W, towards the hand, lies in the screen
  story.settle(400);
  ASSERT_TRUE(story.perform("session.start"));
  story.run(500);
  story.dragHandTo({0.0, 0.0, 0.050});
  story.run(1500);
  const double at_the_surface_N = story.force_N();
  EXPECT_NEAR(story.arm().setpoint().p_WT.z(), 0.050, 0.001);
  story.dragHandTo({0.0, 0.0, 0.044});
  story.run(1500);
  EXPECT_GT(story.force_N(), at_the_surface_N + 0.3);
  EXPECT_LE(story.force_N(), 0.88 + 1e-9);
  EXPECT_GT(story.snapshot().report.force.f_T_W().z(), 0.0);  // outwards: it pushes back
}

TEST(HandStory, TheArrowKeysMoveTheHand) {
  Story story("02_sphere");
  story.perform("view.front");
  story.settle(400);
  story.perform("view.focus");
  const Vec3 before = story.arm().setpoint().p_WT;
  story.key(Qt::Key_Right);
  story.key(Qt::Key_Up, Qt::ShiftModifier);
  const Vec3 moved = story.arm().setpoint().p_WT - before;
  EXPECT_NEAR(moved.x(), 0.002, 1e-9);
  EXPECT_NEAR(moved.y(), 0.010, 1e-9);
}

TEST(HandStory, AStylusThatIsReleasedComesOutOfTheBall) {
  Loose user("02_sphere");
  EXPECT_NEAR(user.away_m(), kBall_m, 2.0 * kFriction_m) << "nobody holds it at first";
  user.story.dragHandTo({0.0, 0.0, 0.030}, true);
  user.story.run(2000);
  EXPECT_LT(user.away_m(), 0.035) << "held while the button is down";
  EXPECT_GT(user.story.force_N(), 0.8);
  EXPECT_EQ(user.story.view().dimplesDrawn(), 1u) << "contact shows";
  user.story.savePicture("pushed");
  user.story.release(&user.story.view(), {10, 10});
  user.story.run(1500);
  EXPECT_NEAR(user.away_m(), kBall_m, 2.0 * kFriction_m);
  EXPECT_LT(user.story.force_N(), 0.3) << "what the arm's friction takes";
}

TEST(HandStory, KeptHoldingItStaysAndTheChoiceIsRemembered) {
  Loose user("02_sphere");
  ASSERT_TRUE(user.story.perform("hand.keep", true));
  user.story.dragHandTo({0.0, 0.0, 0.030});
  user.story.run(2000);
  EXPECT_LT(user.away_m(), 0.035);
  ASSERT_TRUE(user.story.perform("hand.let_go"));
  EXPECT_FALSE(user.story.window().actions().find("hand.keep")->isChecked());
  user.story.run(1500);
  EXPECT_NEAR(user.away_m(), kBall_m, 2.0 * kFriction_m);
  ASSERT_TRUE(user.story.perform("hand.keep", true));
  user.story.window().close();
  EXPECT_TRUE(QSettings().value("hand/keeps_holding").toBool());
}

TEST(HandStory, TakingHoldOfALooseStylusMovesNothing) {
  Loose user("02_sphere");
  user.story.dragHandTo({0.0, 0.0, 0.030});
  user.story.run(1500);
  const Vec3 before = user.story.snapshot().report.p_WT;
  const double force_N = user.story.force_N();
  const QPoint stylus = user.story.view().screenOf(before).toPoint();
  user.story.press(&user.story.view(), stylus);
  for (int step = 0; step < 50; ++step) {
    user.story.run(10);
    EXPECT_LT((user.story.snapshot().report.p_WT - before).norm(), 1e-4) << step;
    EXPECT_NEAR(user.story.force_N(), force_N, 0.05) << step;
  }
  user.story.release(&user.story.view(), stylus);
}

TEST(HandStory, AStylusThatIsOnlyTurnedGoesRoundTheRim) {
  for (const bool keeps : {false, true}) {
    Loose user("14_circle_influence");
    user.story.perform("hand.keep", keeps);
    const Vec3 before = user.story.snapshot().report.p_WT;
    user.story.perform("view.focus");
    for (int step = 0; step < 8; ++step) {
      user.story.key(Qt::Key_Left, Qt::ControlModifier);
      user.story.run(400);
    }
    const double travel_m = (user.story.snapshot().report.p_WT - before).norm();
    if (keeps)
      EXPECT_LT(travel_m, 0.004);
    else
      EXPECT_GT(travel_m, 0.010);
  }
}

TEST(HandStory, TheKeysHoldUntilTheyAreToldToLetGo) {
  Loose user("02_sphere");
  user.story.perform("view.front");
  user.story.settle(400);
  user.story.perform("view.focus");
  user.story.key(Qt::Key_PageUp, Qt::ShiftModifier);  // 10 mm away from the eye, into the ball
  user.story.run(2000);
  EXPECT_LT(user.away_m(), kBall_m - 0.005);
  user.story.key(Qt::Key_F6, Qt::ShiftModifier);
  user.story.run(1500);
  EXPECT_NEAR(user.away_m(), kBall_m, 2.0 * kFriction_m);
}

TEST(HandStory, ASessionWithARelaxedGripIsReplayedAndRunAgainToTheBit) {
  const QTemporaryDir folder;
  forgetSettings();
  QSettings().setValue("hints/has_pushed", true);
  QSettings().setValue("recording/folder", folder.path());
  Loose user("02_sphere", false);
  ASSERT_TRUE(user.story.perform("session.record", true));
  user.story.run(100);
  user.story.dragHandTo({0.0, 0.0, 0.035});
  user.story.run(1000);
  user.story.host().endRecord();  // a recording ends between two ticks: the next one comes here
  user.story.run(1);
  ASSERT_TRUE(user.story.perform("session.record", false));
  const QStringList files = QDir(folder.path()).entryList({"*.h5"});
  ASSERT_EQ(files.size(), 1);
  const QString file = folder.filePath(files.first());
  EXPECT_EQ(runCli({"replay", file, "--verify"}), 0);
  EXPECT_EQ(runCli({"rerun", file}), 0);
}

}  // namespace underact::gui::test
