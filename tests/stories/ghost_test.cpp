#include <gtest/gtest.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/gui/window/features.h"
#include "tests/stories/ghost_desk.h"
#include "tests/stories/language_desk.h"

namespace underact::gui::test {
namespace {

/// How far from the teacher's hand one is at most that comes so many ticks later.
double largestLag_m(int lag) {
  double largest_m = 0.0;
  for (int tick = 0; tick <= kTeacherTicks; ++tick)
    largest_m = std::max(largest_m, (teacherAt(tick) - teacherAt(tick - lag)).norm());
  return largest_m;
}

}  // namespace

TEST(GhostStory, WhoFollowsExactlyIsNearAllTheWayAndIsToldSo) {
  Class story;
  EXPECT_TRUE(story.find("ghost")->isVisible());
  EXPECT_EQ(story.text("ghost.time"), "00:00 / 00:03");
  story.follow(0, kTeacherTicks / 2);
  EXPECT_EQ(story.state().phase, ghost::Phase::Going);
  EXPECT_TRUE(story.text("ghost.told").startsWith("Average 0.")) << story.text("ghost.told").toStdString();
  EXPECT_FALSE(story.find("ghost.copy")->isVisible()) << "there is no result yet";
  story.follow(kTeacherTicks / 2, kTeacherAll);
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
  story.follow(0, kTeacherAll, 300);
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

TEST(GhostStory, AllOfItIsDoneByKeys) {
  Class story;
  story.byPalette("follow a recorded");
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
  story.follow(0, kTeacherAll);
  story.run(500);
  EXPECT_EQ(ended.count(), 1);
  EXPECT_EQ(story.find("ghost.told")->accessibleDescription(), story.text("ghost.told"));
  for (const QWidget* part : story.find("ghost")->findChildren<QWidget*>(QRegularExpression("^ghost\\.")))
    EXPECT_FALSE(part->accessibleName().isEmpty()) << part->objectName().toStdString();
  EXPECT_EQ(helpPageOf(story.find("ghost.speed"), helpPages(features())), "classes#following-a-recorded-hand");
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
    story.follow(700, kTeacherAll, 300);
    EXPECT_TRUE(story.picture().save(made.arg(QString("result_") + theme)));
  }
  Class elsewhere("03_line");
  elsewhere.run(100);
  EXPECT_TRUE(elsewhere.picture().save(QString(UNDERACT_BINARY) + "/pictures/ghost_elsewhere.png"));
}

}  // namespace underact::gui::test
