#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "app/gui/ghost/ghost_hand.h"
#include "app/gui/model/player.h"
#include "app/gui/visitor/visitor_mode.h"
#include "app/gui/window/features.h"
#include "core/record/recorder.h"
#include "core/scene/read.h"
#include "tests/stories/language_desk.h"
#include "tests/stories/session_desk.h"

namespace underact::gui::test {
namespace {

constexpr int kTeacherTicks = 3000, kStep = 25;  // of the teacher's hand; between two wishes
constexpr int kAll = kTeacherTicks + 2 * kStep;  // in which the ghost has come to its end

/// The teacher's hand: 30 mm to the right and back, in a loop, in 3 s.
Vec3 teacherAt(int tick) {
  const double angle_rad = 3.14159265 * std::clamp(tick, 0, kTeacherTicks) / kTeacherTicks;
  return {0.030 * std::sin(angle_rad), 0.015 * std::sin(2.0 * angle_rad), 0.06};
}

/// How far from the teacher's hand one is at most that comes so many ticks later.
double largestLag_m(int lag) {
  double largest_m = 0.0;
  for (int tick = 0; tick <= kTeacherTicks; ++tick)
    largest_m = std::max(largest_m, (teacherAt(tick) - teacherAt(tick - lag)).norm());
  return largest_m;
}

void moveHand(device::SimulatedArm& arm, const Vec3& p_W) {
  sim::HandSetpoint setpoint = arm.setpoint();
  setpoint.p_WT = p_W;
  arm.setSetpoint(setpoint);
}

/// A session of 3 s beside the sphere.
QString teacherSession() {
  static const QString kPath = [] {
    const QString path = temporaryFile("teacher.h5");
    SimulatedHost simulated = makeSimulatedHost({.clock = servo::Clock::Manual});
    Document document(*simulated.host);
    EXPECT_TRUE(document.open(scene::readSceneFile(shippedScene("02_sphere").toStdString()).value()).empty());
    moveHand(*simulated.arm, teacherAt(0));
    simulated.host->run(500);
    auto recorder = record::Recorder::start(*simulated.host, path.toStdString(), {.name = "Round the ball"});
    EXPECT_TRUE(static_cast<bool>(recorder));
    for (int tick = 0; tick < kTeacherTicks; tick += kStep) {
      moveHand(*simulated.arm, teacherAt(tick));
      simulated.host->run(kStep);
    }
    EXPECT_TRUE(recorder.value()->stop().empty());
    return path;
  }();
  return kPath;
}

/// Waits for what is read in another thread; no tick comes meanwhile.
bool waitFor(const std::function<bool()>& what) {
  return QTest::qWaitFor(what, kLong_ms);
}

/// A window with the teacher's ghost in it.
struct Class : Story {
  explicit Class(const QString& scene = "02_sphere", const QString& path = teacherSession()) : Story(scene) {
    moveHand(arm(), teacherAt(0));
    run(500);
    EXPECT_TRUE(perform("ghost.open", path));
    EXPECT_TRUE(waitFor([this] { return ghost().isOpen(); }));
  }
  GhostHand& ghost() { return *window().findChild<GhostHand*>(); }
  const ghost::State& state() { return ghost().state(); }
  /// The student's hand does what the teacher's did from one tick to another, so many ticks later.
  void follow(int from, int to, int lag = 0) {
    for (int tick = from; tick < to; tick += kStep) {
      moveHand(arm(), teacherAt(tick - lag));
      run(kStep);
    }
  }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
};

}  // namespace

TEST(GhostStory, WhoFollowsExactlyIsNearAllTheWayAndIsToldSo) {
  Class story;
  EXPECT_TRUE(story.find("ghost")->isVisible());
  EXPECT_EQ(story.text("ghost.time"), "00:00 / 00:03");
  story.follow(0, kTeacherTicks / 2);
  EXPECT_EQ(story.state().phase, ghost::Phase::Going);
  EXPECT_TRUE(story.text("ghost.told").startsWith("Average 0.")) << story.text("ghost.told").toStdString();
  EXPECT_FALSE(story.find("ghost.copy")->isVisible()) << "there is no result yet";
  story.follow(kTeacherTicks / 2, kAll);
  ASSERT_EQ(story.state().phase, ghost::Phase::Ended);
  EXPECT_LT(story.state().last_round->largest_m, 0.001);
  EXPECT_EQ(story.state().last_round->nearShare(), 1.0);
  const QString result = story.text("ghost.told");
  EXPECT_TRUE(result.startsWith("Followed for 3 s: 0.")) << result.toStdString();
  EXPECT_TRUE(result.endsWith("100 % of the time within 10 mm.")) << result.toStdString();
  EXPECT_FALSE(story.find("ghost.last")->isVisible()) << "said already";
  story.click(story.find("ghost.copy"));
  EXPECT_EQ(QGuiApplication::clipboard()->text(), result);
  EXPECT_EQ(story.find<QPushButton>("ghost.copy")->text(), "Copied");
}

TEST(GhostStory, WhoLagsIsFartherAway) {
  Class story;
  story.follow(0, kAll, 300);
  ASSERT_TRUE(story.state().last_round);
  EXPECT_NEAR(story.state().last_round->largest_m, largestLag_m(300), 0.001);
  EXPECT_GT(story.state().last_round->mean_m(), 0.004);
}

TEST(GhostStory, ItWaitsForWhoStaysBehindAndGoesOnWhenHeIsThere) {
  Class story;
  story.run(1500);
  EXPECT_EQ(story.state().phase, ghost::Phase::Waiting);
  EXPECT_EQ(story.text("ghost.told"), "The ghost waits until you are within 10 mm.");
  EXPECT_NEAR(story.state().distance_m, 0.020, 0.001);
  const double waited_at_s = story.state().time_s;
  moveHand(story.arm(), story.state().ghost.p_WG);
  story.run(500);
  EXPECT_EQ(story.state().phase, ghost::Phase::Going);
  EXPECT_GT(story.state().time_s, waited_at_s);
  EXPECT_TRUE(story.text("ghost.told").startsWith("Average ")) << story.text("ghost.told").toStdString();
  story.type(story.find("ghost.wait_beyond"), "50");
  EXPECT_NEAR(story.ghost().options().waits_beyond_m, 0.050, 1e-12);
  moveHand(story.arm(), teacherAt(0));
  story.run(4000);
  EXPECT_EQ(story.state().phase, ghost::Phase::Ended) << "30 mm are not too far";
  EXPECT_TRUE(story.text("ghost.told").endsWith("The ghost waited for 1 s.")) << story.text("ghost.told").toStdString();
}

TEST(GhostStory, SpeedLoopAndWaitingAreChosenInTheStrip) {
  Class story;
  story.click(story.find("ghost.wait"), {8, story.find("ghost.wait")->height() / 2});
  EXPECT_FALSE(story.ghost().options().waits);
  story.click(story.find("ghost.loop"), {8, story.find("ghost.loop")->height() / 2});
  EXPECT_TRUE(story.ghost().options().loops);
  ASSERT_TRUE(story.perform("ghost.speed", 0.5));
  EXPECT_EQ(story.find<QComboBox>("ghost.speed")->currentText(), QString::fromUtf8("0.5 ×"));
  story.run(1000);
  EXPECT_NEAR(story.state().time_s, 0.5, 0.01);
  ASSERT_TRUE(story.perform("ghost.speed", 2.0));
  story.run(1500);
  EXPECT_EQ(story.state().rounds, 1);
  EXPECT_TRUE(story.text("ghost.last").startsWith("Last round: Followed for 2 s: "))
      << story.text("ghost.last").toStdString();
  story.run(1500);
  EXPECT_EQ(story.state().rounds, 2);
  for (const double speed : {0.05, 3.0}) EXPECT_FALSE(story.perform("ghost.speed", speed));
  EXPECT_FALSE(story.perform("ghost.wait_beyond", "far"));
}

TEST(GhostStory, ItBeginsWithTheOneWhoFollows) {
  Class story;
  story.perform("ghost.play", false);
  moveHand(story.arm(), {-0.03, 0.0, 0.06});
  story.run(1000);
  EXPECT_TRUE(story.text("ghost.told").startsWith("The ghost is paused."));
  story.perform("ghost.play", true);
  story.run(1000);
  EXPECT_EQ(story.state().phase, ghost::Phase::Ready);
  EXPECT_EQ(story.text("ghost.told"), "Move to the ghost: it starts when you are within 10 mm.");
  moveHand(story.arm(), teacherAt(0));
  story.run(500);
  EXPECT_EQ(story.state().phase, ghost::Phase::Going);
  ASSERT_TRUE(story.perform("ghost.restart"));
  ASSERT_TRUE(story.perform("ghost.near", false));
  moveHand(story.arm(), {-0.01, 0.0, 0.06});
  story.run(250);
  EXPECT_NE(story.state().phase, ghost::Phase::Ready);
}

TEST(GhostStory, TheSceneStaysAndTheOneItWasRecordedInIsOffered) {
  Class story("03_line");
  EXPECT_EQ(story.window().document().scene().title, "Line");
  EXPECT_EQ(story.text("ghost.notes"), QString::fromUtf8("It was recorded in the scene “Sphere”."));
  story.click(story.find("ghost.scene"));
  EXPECT_EQ(story.window().document().scene().title, "Sphere");
  EXPECT_FALSE(story.find("ghost.notes")->isVisible());
  EXPECT_FALSE(story.find("ghost.scene")->isVisible());
  scene::Description other = story.window().document().scene();
  other.control.gains.kp_N_per_mm *= 0.5;
  ASSERT_TRUE(story.window().document().edit(other, "softer", 1).empty());
  EXPECT_FALSE(story.find("ghost.notes")->isVisible()) << "how hard it pulls is another matter";
  std::get<scene::Sphere>(other.constraints.front().shape).radius_mm += 5.0;
  ASSERT_TRUE(story.window().document().edit(other, "larger", 2).empty());
  EXPECT_EQ(story.text("ghost.notes"), "The scene has changed since the recording.");
}

TEST(GhostStory, ForTheLeftHandItGoesInTheSameMirrorAsTheScenes) {
  constexpr double kBehind_m = 0.002;  // of its wish the recorded hand was; the mirror image is 50 mm away
  Class story;
  EXPECT_FALSE(story.find("ghost.mirror")->isVisible());
  moveHand(story.arm(), {-0.020, 0.0, 0.06});
  ASSERT_TRUE(story.perform("scene.left_handed", true));
  EXPECT_TRUE(story.find<QCheckBox>("ghost.mirror")->isChecked());
  ASSERT_TRUE(story.perform("ghost.near", false));
  ASSERT_TRUE(story.perform("ghost.wait", false));
  story.run(1000);
  EXPECT_NEAR(story.state().ghost.p_WG.x(), -teacherAt(1000).x(), kBehind_m);
  ASSERT_TRUE(story.perform("ghost.mirror", false));
  ASSERT_TRUE(story.perform("ghost.near", false));
  story.run(1000);
  EXPECT_NEAR(story.state().ghost.p_WG.x(), teacherAt(1000).x(), kBehind_m);
  ASSERT_TRUE(story.perform("scene.open", shippedScene("03_line")));
  for (const bool mirrored : {true, false}) {  // its scene is opened as the ghost goes, whatever the window's hand
    ASSERT_TRUE(story.perform("ghost.mirror", mirrored));
    ASSERT_TRUE(story.perform("ghost.scene"));
    EXPECT_FALSE(story.ghost().isElsewhere()) << mirrored;
  }
  ASSERT_TRUE(story.perform("scene.left_handed", false));
}

TEST(GhostStory, ASceneWithFilesIsKnownAgain) {
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

TEST(GhostStory, NothingOfItIsDrawnWhenItIsClosed) {
  const auto ghostly = [](const QImage& image) {  // pixels of its colour
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor colour = image.pixelColor(x, y);
        count += colour.saturation() > 60 && colour.hue() > 312 && colour.hue() < 342 ? 1 : 0;
      }
    }
    return count;
  };
  Class story;
  ASSERT_TRUE(story.perform("ghost.play", false));
  moveHand(story.arm(), {-0.02, 0.01, 0.06});
  story.run(1000);
  EXPECT_GT(ghostly(story.view().picture()), 300);
  ASSERT_TRUE(story.perform("ghost.close"));
  EXPECT_FALSE(story.find("ghost")->isVisible());
  EXPECT_FALSE(story.perform("ghost.play"));
  story.settle(300);
  EXPECT_LT(ghostly(story.view().picture()), 20) << "but where two other colours meet";
}

TEST(GhostStory, AFileThatIsNoSessionIsSaidAndNothingChanges) {
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

TEST(GhostStory, WhatIsDamagedIsSaidAndTheRestIsFollowed) {
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

TEST(GhostStory, ReadingCanBeCancelledAndNothingChanges) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("ghost.open", teacherSession()));
  ASSERT_TRUE(story.find("load.cancel")->isVisible());
  story.find<QPushButton>("load.cancel")->click();  // at once: before anybody looks at what was read
  story.settle(300);
  EXPECT_FALSE(story.window().findChild<GhostHand*>()->isOpen());
  EXPECT_EQ(story.window().findChild<QMessageBox*>("dialog.session_problems"), nullptr);
}

TEST(GhostStory, AReplayAndAGhostAreNotThereTogether) {
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

TEST(GhostStory, VisitorsFollowNobody) {
  Class story;
  ASSERT_TRUE(story.perform("visitor.start", QStringList{shippedScene("02_sphere")}));
  story.run(100);
  EXPECT_FALSE(story.ghost().isOpen());
  story.window().findChild<VisitorMode*>()->leave();
}

TEST(GhostStory, ASessionOfTheListIsFollowedByItsMenu) {
  Desk desk;
  const QString path = desk.session(400, "by the teacher");
  ASSERT_TRUE(desk.listed(1));
  ASSERT_TRUE(desk.choose(path));
  ASSERT_TRUE(desk.story->perform("sessions.follow"));
  ASSERT_TRUE(waitFor([&] { return desk.story->window().findChild<GhostHand*>()->isOpen(); }));
  EXPECT_EQ(desk.story->window().findChild<GhostHand*>()->ghost().name, "by the teacher");
}

TEST(GhostStory, AllOfItIsDoneByKeys) {
  Class story;
  story.key(Qt::Key_G, Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
  auto* dialog = story.find<QFileDialog>("dialog.follow");
  ASSERT_NE(dialog, nullptr);
  dialog->close();
  story.bringToFront(&story.window());
  story.perform("view.focus");
  story.key(Qt::Key_G);
  EXPECT_FALSE(story.ghost().isPlaying());
  story.key(Qt::Key_G);
  EXPECT_TRUE(story.ghost().isPlaying());
  story.run(500);
  story.key(Qt::Key_G, Qt::ShiftModifier);
  EXPECT_EQ(story.state().time_s, 0.0);
  QStringList reached;
  for (int step = 0; step < 9; ++step) {
    story.key(Qt::Key_Tab);
    if (QApplication::focusWidget() != nullptr) reached << QApplication::focusWidget()->objectName();
  }
  for (const char* name : {"ghost.play", "ghost.restart", "ghost.speed", "ghost.close", "ghost.wait",
                           "ghost.wait_beyond", "ghost.near", "ghost.loop"})
    EXPECT_TRUE(reached.contains(name)) << name << " in " << reached.join(' ').toStdString();
  story.key(Qt::Key_G, Qt::ControlModifier);
  EXPECT_FALSE(story.ghost().isOpen());
}

TEST(GhostStory, AScreenReaderGetsTheResultOnceAndEachPartHasANameAndAPage) {
  Class story;
  QSignalSpy ended(&story.ghost(), &GhostHand::ended);
  story.follow(0, kAll);
  story.run(500);
  EXPECT_EQ(ended.count(), 1);
  EXPECT_EQ(story.find("ghost.told")->accessibleDescription(), story.text("ghost.told"));
  for (const QWidget* part : story.find("ghost")->findChildren<QWidget*>(QRegularExpression("^ghost\\.")))
    EXPECT_FALSE(part->accessibleName().isEmpty()) << part->objectName().toStdString();
  EXPECT_EQ(helpPageOf(story.find("ghost.speed"), helpPages(features())), "following");
}

TEST(GhostStory, NothingOfItIsCutInASmallWindowAndInGerman) {
  for (const bool in_german : {false, true}) {
    std::optional<German> german;
    if (in_german) german.emplace();
    Class story("03_line");
    story.window().resize(1024, 700);
    ASSERT_TRUE(story.perform("ghost.wait", false));
    story.run(3500);
    story.settle();
    EXPECT_EQ(story.window().width(), 1024);
    EXPECT_EQ(cutWords(*story.find("ghost")).join('\n').toStdString(), "");
    const QString made = QString(UNDERACT_BINARY) + "/pictures/ghost_small_%1.png";
    EXPECT_TRUE(story.picture().save(made.arg(in_german ? "german" : "english")));
  }
}

// To be looked at by people; the light one stands in the guide.
TEST(GhostStory, PicturesOfIt) {
  for (const char* theme : {"light", "dark"}) {
    Class story;
    story.perform(QString("view.theme.") + theme);
    story.follow(0, 700, 300);
    story.view().setHint({});
    story.savePicture(QString("ghost_") + theme);
    story.perform("view.projector", true);
    story.settle(300);
    EXPECT_TRUE(story.find("ghost")->isVisible()) << "a class sees how near one is";
    const QString made = QString(UNDERACT_BINARY) + "/pictures/ghost_%1.png";
    EXPECT_TRUE(story.picture().save(made.arg(QString("projector_") + theme)));
    story.perform("view.projector", false);
    story.follow(700, kAll, 300);
    EXPECT_TRUE(story.picture().save(made.arg(QString("result_") + theme)));
  }
  Class elsewhere("03_line");
  elsewhere.run(100);
  EXPECT_TRUE(elsewhere.picture().save(QString(UNDERACT_BINARY) + "/pictures/ghost_elsewhere.png"));
}

}  // namespace underact::gui::test
