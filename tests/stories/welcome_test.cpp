#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSlider>

#include "app/gui/welcome/tour.h"
#include "tests/stories/docks_seen.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

/// The program's very first start: nothing is remembered.
struct FirstStart {
  FirstStart() {
    forgetSettings();
    story = std::make_unique<Story>("02_sphere", Beginning{.first_start = false, .keeps_holding = false});
    story->window().resize(1280, 800);
    story->perform("session.start");
    story->run(500);
    story->settle();  // the card has moved the camera, and its frame follows with the next picture
  }
  QWidget* card() { return story->find("welcome"); }
  QString row(const char* name) { return story->find<QLabel>(QString("welcome.") + name)->text(); }
  bool isTicked(const char* name) { return row(name).startsWith(QString::fromUtf8("✓")); }
  bool coversTheStylus() { return QRectF(card()->geometry()).intersects(story->view().stylusOnScreen()); }
  void leavesInAWhile() {
    EXPECT_TRUE(card()->isVisible()) << "the sentence is to be read";
    EXPECT_FALSE(story->find<QLabel>("welcome.confirmed")->text().isEmpty());
    story->run(4500);
    EXPECT_FALSE(card()->isVisible());
    EXPECT_FALSE(story->find("welcome.frame")->isVisible());
  }

  std::unique_ptr<Story> story;
};

}  // namespace

TEST(WelcomeStory, ItCountsItsThreeThingsFramesTheNextAndStaysUntilAllAreDone) {
  FirstStart first;
  Story& story = *first.story;
  const QWidget* frame = story.find("welcome.frame");
  const QWidget* slider = story.find("panel.gains.kp.x");
  const auto frames = [&](const QRect& place) { return frame->isVisible() && frame->geometry().contains(place); };
  const auto stylus = [&] {
    return story.view().stylusOnScreen().toAlignedRect().translated(story.view().mapTo(&story.window(), QPoint()));
  };
  const auto sliderPlace = [&] { return QRect(slider->mapTo(&story.window(), QPoint()), slider->size()); };
  const auto title = [&] { return story.find<QLabel>("welcome.title")->text(); };
  ASSERT_TRUE(first.card()->isVisible());
  EXPECT_FALSE(first.coversTheStylus());
  EXPECT_EQ(title(), "Three things to try: 0 of 3 done");
  EXPECT_TRUE(frames(stylus())) << "one thing to do: the stylus";
  EXPECT_FALSE(frame->mask().contains(frame->rect().center())) << "a frame, no veil";
  story.perform("view.top");
  story.settle(400);
  story.dragHandTo({0.0, 0.0, 0.040});
  EXPECT_TRUE(first.isTicked("push"));
  EXPECT_EQ(title(), "Three things to try: 1 of 3 done");
  story.run(6000);
  ASSERT_TRUE(first.card()->isVisible()) << "two are left";
  EXPECT_TRUE(frames(sliderPlace()));
  story.find("panel.gains.kp.x.slider")->setFocus();
  story.key(Qt::Key_Right);
  story.run(1);
  EXPECT_TRUE(first.isTicked("slider"));
  EXPECT_FALSE(first.isTicked("turn"));
  story.perform("view.focus");
  for (int step = 0; step < 6; ++step) {
    QTest::keyPress(story.window().windowHandle(), Qt::Key_Left, Qt::ControlModifier);
    story.run(100);
  }
  EXPECT_TRUE(first.isTicked("turn"));
  EXPECT_EQ(title(), "Three things to try: 3 of 3 done");
  QTest::keyRelease(story.window().windowHandle(), Qt::Key_Left, Qt::ControlModifier);
  first.leavesInAWhile();
  first.story.reset();
  EXPECT_TRUE(QSettings().value("hints/has_pushed").toBool());
  Story second("02_sphere", {.first_start = false});
  second.run(2000);
  EXPECT_FALSE(second.find("welcome")->isVisible());
  ASSERT_TRUE(second.perform("help.welcome"));
  second.run(10);
  EXPECT_TRUE(second.find("welcome")->isVisible());
}

TEST(WelcomeStory, AFirstStartThatDidNotDoAllIsAskedAgain) {
  {
    FirstStart first;
    first.story->perform("view.top");
    first.story->settle(400);
    first.story->dragHandTo({0.0, 0.0, 0.040});
    EXPECT_TRUE(first.isTicked("push"));
  }
  Story second("02_sphere", {.first_start = false});
  second.run(500);
  EXPECT_TRUE(second.find("welcome")->isVisible());
}

TEST(WelcomeStory, ItsNumbersAreThoseOfTheGaugeAndTheLimitIsExplained) {
  FirstStart first;
  Story& story = *first.story;
  story.perform("view.top");
  story.settle(400);
  for (const double z_m : {0.047, 0.030}) {
    story.dragHandTo({0.0, 0.0, z_m}, true);
    story.run(1000);
    const QString live = first.row("live");
    EXPECT_TRUE(live.startsWith(QString("Force now: %1 of 0.88 N.").arg(story.force_N(), 0, 'f', 2)))
        << live.toStdString();
    EXPECT_EQ(live.contains("push less deeply"), z_m < 0.04) << live.toStdString();
    story.release(&story.view(), {10, 10});
    story.run(1500);
  }
}

TEST(WelcomeStory, EscIsStillStopAndCloseEndsItForGood) {
  FirstStart first;
  Story& story = *first.story;
  story.key(Qt::Key_Escape);
  story.run(100);
  EXPECT_FALSE(story.host().running());
  EXPECT_TRUE(first.card()->isVisible());
  story.click(story.find("welcome.close"));
  story.run(1);
  EXPECT_FALSE(first.card()->isVisible());
  first.story.reset();
  EXPECT_TRUE(QSettings().value("hints/has_pushed").toBool());
}

TEST(WelcomeStory, ItStandsWhereTheStylusIsNotWhereverThatIsTaken) {
  FirstStart first;
  Story& story = *first.story;
  const Vec3 places[] = {{-0.07, 0.05, 0.03}, {0.07, 0.05, 0.03}, {-0.07, -0.05, 0.03}, {0.07, -0.05, 0.03}};
  for (const Vec3& place : places) {
    story.arm().setSetpoint({.p_WT = place});
    story.run(1500);
    ASSERT_TRUE(first.card()->isVisible());
    EXPECT_FALSE(first.coversTheStylus()) << place.transpose();
    EXPECT_TRUE(story.view().rect().contains(first.card()->geometry())) << place.transpose();
  }
}

TEST(WelcomeStory, OnALowScreenItHasTheNextThingAloneAndKeepsClearOfTheStylus) {
  FirstStart first;
  Story& story = *first.story;
  story.window().resize(960, 500);  // as 1080p leaves it at 200 %
  story.run(1500);
  ASSERT_TRUE(first.card()->isVisible());
  EXPECT_FALSE(first.coversTheStylus());
  EXPECT_TRUE(story.view().rect().contains(first.card()->geometry()));
  EXPECT_TRUE(story.find("welcome.push")->isVisible());
  EXPECT_FALSE(story.find("welcome.slider")->isVisible());
  story.window().resize(1280, 800);
  story.run(1500);
  EXPECT_TRUE(story.find("welcome.slider")->isVisible());
}

TEST(WelcomeStory, ItSaysWhatThereIsToFeelInEachScene) {
  FirstStart first;
  Story& story = *first.story;
  EXPECT_TRUE(first.row("push").contains("Push into the sphere"));
  story.perform("scene.open", shippedScene("03_line"));
  EXPECT_TRUE(first.row("push").contains("Pull the stylus away from the line"));
  story.perform("scene.open", shippedScene("16_one_joint_robot"));
  EXPECT_TRUE(first.row("push").contains("end effector of the virtual robot"));
}

TEST(TourStory, EachStopFramesItsPartAndEscLeavesAtEachWithThePanelsAsTheyWere) {
  Story story("02_sphere");
  const std::map<std::string, int> before = docksSeen(story.window());
  for (int last = 0; last < Tour::stops(); ++last) {
    story.perform("session.start");
    ASSERT_TRUE(story.perform("help.tour"));
    for (int stop = 0; stop < last; ++stop) {
      story.key(Qt::Key_Return);
      story.settle(20);
    }
    auto* tour = story.find<Tour>("tour");
    ASSERT_EQ(tour->stop(), last);
    ASSERT_TRUE(tour->isVisible());
    EXPECT_EQ(story.find<QLabel>("tour.count")->text(), QString("%1 of %2").arg(last + 1).arg(Tour::stops()));
    EXPECT_TRUE(tour->accessibleDescription().contains(story.find<QLabel>("tour.text")->text()));
    int frames = 0;
    for (const char* name : {"welcome.frame", "tour.frame"}) frames += story.find(name)->isVisible() ? 1 : 0;
    EXPECT_EQ(frames, 1) << "stop " << last;
    EXPECT_TRUE(story.window().rect().contains(tour->geometry())) << "stop " << last;
    story.key(Qt::Key_Escape);
    story.run(1);
    EXPECT_FALSE(tour->isVisible()) << "stop " << last;
    EXPECT_EQ(tour->stop(), -1);
    EXPECT_TRUE(story.host().running()) << "Esc leaves the tour first";
    story.settle();
    EXPECT_EQ(docksSeen(story.window()), before) << "stop " << last;
  }
}

TEST(TourStory, BackNextDoneAndCloseByMouse) {
  Story story("02_sphere");
  story.perform("help.tour");
  auto* tour = story.find<Tour>("tour");
  EXPECT_FALSE(story.find("tour.back")->isEnabled());
  story.click(story.find("tour.next"));
  story.click(story.find("tour.next"));
  story.click(story.find("tour.back"));
  EXPECT_EQ(tour->stop(), 1);
  story.click(story.find("tour.close"));
  EXPECT_EQ(tour->stop(), -1);
  story.perform("help.tour");
  for (int stop = 1; stop < Tour::stops(); ++stop) story.find<QPushButton>("tour.next")->click();
  EXPECT_EQ(story.find<QPushButton>("tour.next")->text(), "Done");
  story.find<QPushButton>("tour.next")->click();
  EXPECT_FALSE(tour->isVisible());
}

// To be looked at by people, and for the guide.
TEST(WelcomeStory, PicturesOfWelcomeAndTour) {
  for (const char* theme : {"light", "dark"}) {
    FirstStart first;
    first.story->perform(QString("view.theme.") + theme);
    first.story->run(500);
    first.story->savePicture(QString("welcome_") + theme);
    first.story->find<QPushButton>("welcome.close")->click();
    first.story->perform("help.tour");
    for (int stop = 0; stop < 3; ++stop) first.story->find<QPushButton>("tour.next")->click();
    first.story->run(500);
    first.story->savePicture(QString("tour_") + theme);
  }
}

TEST(WelcomeStory, ItAsksWhatTheWindowIsFor) {
  FirstStart first;
  auto* const teach = first.story->find<QToolButton>("welcome.purpose.teach");
  ASSERT_TRUE(teach->isVisible());
  first.story->savePicture("welcome_purpose");
  teach->click();
  first.story->settle();
  EXPECT_TRUE(first.story->find("rail.lessons")->isVisible());
  EXPECT_TRUE(teach->isChecked());
}

}  // namespace underact::gui::test
