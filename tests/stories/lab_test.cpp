#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QUndoStack>

#include "app/gui/lab/choice_list.h"
#include "app/gui/lab/front_chart.h"
#include "app/gui/lab/lab_words.h"
#include "core/scene/edit.h"
#include "core/tradeoff/settings.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

struct Lab : Story {
  explicit Lab(const QString& scene = "05_circle", const Beginning& beginning = {}) : Story(scene, beginning) {
    EXPECT_TRUE(perform("dock.lab", true));
    settle();
  }
  QString text(const QString& part) { return find<QLabel>("panel.lab." + part)->text(); }
  QSlider* walk() { return find<QSlider>("panel.lab.walk"); }
  bool isBusy() { return !find("panel.lab.progress")->isHidden(); }
  /// One hand and short runs: what is asked here is what the panel does with the figures.
  void measure(const QString& hand = "sweep", double seconds = 0.3) {
    EXPECT_TRUE(perform("lab.measure", hand, seconds));
    EXPECT_TRUE(isBusy());
    EXPECT_TRUE(QTest::qWaitFor([this] { return !isBusy(); }, 240'000));
    settle();
  }
  const scene::Description& scene() { return window().document().scene(); }
  tradeoff::Settings settings() { return tradeoff::settingsOf(scene(), host().rateHz()); }
  bool isAsIt(const scene::Description& was) { return scene::isSame(scene(), was); }
  int last() { return walk()->maximum(); }
  QPoint handle() {
    QStyleOptionSlider option;
    option.initFrom(walk());
    option.minimum = walk()->minimum();
    option.maximum = walk()->maximum();
    option.sliderPosition = option.sliderValue = walk()->sliderPosition();
    return walk()->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, walk()).center();
  }
};

}  // namespace

TEST(LabStory, BeforeItIsMeasuredItSaysWhatMeasuringDoesAndWhatTheSceneOffers) {
  Lab story;
  EXPECT_TRUE(story.text("told").contains("Nothing has been measured yet"));
  EXPECT_TRUE(story.text("told").contains("about"));
  EXPECT_FALSE(story.walk()->isEnabled());
  EXPECT_FALSE(story.find("panel.lab.back")->isEnabled());
  EXPECT_FALSE(story.perform("lab.walk", 0));
  EXPECT_FALSE(story.perform("lab.back"));
  EXPECT_FALSE(story.perform("lab.cancel"));
  EXPECT_FALSE(story.perform("lab.measure", "nobody", 1.0));
  EXPECT_EQ(story.text("choice.rate.value"), "Servo rate: 1000 Hz");
  EXPECT_EQ(story.text("choice.simulation.value"), "Simulated arm: trapezoidal, 200 µs");
  EXPECT_TRUE(story.find("panel.lab.choice.rate.figures")->isHidden());
  EXPECT_EQ(story.window().findChild<QLabel*>("panel.lab.choice.velocity.value"), nullptr);  // a P law has no rate
  EXPECT_TRUE(story.find("panel.lab.choice.rate")->toolTip().contains("16 kHz"));
  EXPECT_TRUE(story.text("tick").contains("predicted"));
}

TEST(LabStory, ThatItsArmIsTheVendorsIsSaidWhereAnotherOneIsSimulated) {
  const QString arm = temporaryFile("unheeded.json", R"({"underact_arm_model": 1, "name": "heavy", "title": "Heavy",
    "provenance": {"device": "a bench", "date": "2026-11-22"}, "mass_kg": 0.12, "friction_N": 0.05})");
  Lab story;
  EXPECT_FALSE(story.text("told").contains("vendor"));
  ASSERT_TRUE(story.perform("arm.open", arm));
  EXPECT_TRUE(story.text("told").contains("vendor's values, not those of “heavy”")) << story.text("told").toStdString();
  ASSERT_TRUE(story.perform("arm.vendor"));
  EXPECT_FALSE(story.text("told").contains("vendor"));
}

TEST(LabStory, TheFrontIsWalkedFromTheCheapestToTheMostExactAndBack) {
  Lab story;
  const scene::Description own = story.scene();
  QUndoStack& undo = story.window().document().undoStack();
  story.measure();
  ASSERT_GE(story.last(), 2) << "three points at least";
  EXPECT_TRUE(story.walk()->isEnabled());
  EXPECT_TRUE(story.text("choice.rate.figures").contains("bound"));
  EXPECT_TRUE(story.text("differences").contains("Nothing differs"));
  ASSERT_TRUE(story.perform("lab.walk", 0));
  const tradeoff::Settings fast = story.settings();
  EXPECT_LT(fast.rate_hz, 1000) << "a quarter of the ticks costs less";
  EXPECT_TRUE(story.text("differences").contains(QString("servo rate: 1000 Hz → %1 Hz").arg(fast.rate_hz)));
  EXPECT_EQ(story.walk()->value(), 0);
  ASSERT_TRUE(story.perform("lab.walk", 1.0));
  const tradeoff::Settings exact = story.settings();
  EXPECT_EQ(story.walk()->value(), story.last());
  EXPECT_GT(exact.rate_hz, fast.rate_hz);
  EXPECT_EQ(story.host().rateHz(), exact.rate_hz);
  const bool is_scene_changed = !story.isAsIt(own);
  EXPECT_EQ(story.text("differences").contains("simulated arm"), is_scene_changed);
  if (is_scene_changed) {
    ASSERT_TRUE(story.perform("lab.back"));
    ASSERT_TRUE(story.perform("edit.undo"));  // of the way back
    story.settle();
    EXPECT_EQ(story.scene().simulation, exact.simulation);
  }
  ASSERT_TRUE(story.perform("lab.walk", 0));
  ASSERT_TRUE(story.perform("lab.back"));
  EXPECT_TRUE(story.isAsIt(own));
  EXPECT_EQ(story.host().rateHz(), 1000);
  EXPECT_TRUE(story.text("differences").contains("Nothing differs"));
  while (undo.canUndo()) undo.undo();
  EXPECT_TRUE(story.isAsIt(own));
  EXPECT_FALSE(story.perform("lab.walk", story.last() + 1));
  EXPECT_FALSE(story.perform("lab.walk", 1.5));
}

TEST(LabStory, ADragIsOneStepBackAndTheRateComesWhenItEnds) {
  Lab story;
  const scene::Description own = story.scene();
  story.measure();
  ASSERT_GE(story.last(), 2);
  ASSERT_TRUE(story.perform("lab.walk", story.last()));
  ASSERT_TRUE(story.perform("lab.back"));
  story.window().document().undoStack().clear();
  const int rate_hz = story.host().rateHz();
  story.perform("session.start");
  story.run(500);
  auto* const walk = story.walk();
  story.press(walk, story.handle());
  ASSERT_TRUE(walk->isSliderDown());
  for (int x = story.handle().x(); x < walk->width() + 20; x += 4) story.moveTo(walk, QPoint(x, walk->height() / 2));
  EXPECT_EQ(walk->value(), story.last());
  for (int x = walk->width(); x > -20; x -= 4) story.moveTo(walk, QPoint(x, walk->height() / 2));
  EXPECT_EQ(walk->value(), 0);
  EXPECT_EQ(story.host().rateHz(), rate_hz) << "while it is held";
  EXPECT_TRUE(story.text("chosen").contains("when you let go"));
  EXPECT_EQ(story.host().snapshot().mode, servo::Mode::Running);
  story.release(walk, QPoint(0, walk->height() / 2));
  EXPECT_NE(story.host().rateHz(), rate_hz);
  EXPECT_TRUE(story.host().running()) << "it goes on by itself";
  EXPECT_FALSE(story.text("chosen").contains("when you let go"));
  EXPECT_LE(story.window().document().undoStack().count(), 1);
  if (story.window().document().undoStack().canUndo()) story.perform("edit.undo");
  EXPECT_TRUE(story.isAsIt(own));
}

TEST(LabStory, KeysWalkTooAndADoubleClickGoesBack) {
  Lab story;
  story.measure();
  ASSERT_GE(story.last(), 2);
  ASSERT_TRUE(story.perform("lab.walk", 0));
  const int slow_hz = story.host().rateHz();
  story.walk()->setFocus(Qt::TabFocusReason);
  for (int step = 0; step < story.last(); ++step) story.key(Qt::Key_Right);
  EXPECT_EQ(story.walk()->value(), story.last());
  EXPECT_GT(story.host().rateHz(), slow_hz);
  QTest::mouseDClick(story.walk(), Qt::LeftButton);
  EXPECT_EQ(story.host().rateHz(), 1000);
}

TEST(LabStory, ACancelledMeasurementLeavesNothing) {
  Lab story;
  ASSERT_TRUE(story.perform("lab.measure", "", 4.0));
  EXPECT_FALSE(story.perform("lab.measure", "", 4.0)) << "one at a time";
  EXPECT_FALSE(story.find("panel.lab.measure")->isEnabled());
  QTest::qWait(300);
  const std::int64_t ticks = story.snapshot().ticks;
  story.run(100);
  EXPECT_EQ(story.snapshot().ticks, ticks + 100) << "the servo goes on";
  story.click(story.find("panel.lab.cancel"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !story.isBusy(); }, 120'000));
  EXPECT_TRUE(story.text("told").startsWith("Cancelled."));
  EXPECT_FALSE(story.walk()->isEnabled());
  EXPECT_TRUE(story.find("panel.lab.choice.rate.figures")->isHidden());
  EXPECT_TRUE(story.find("panel.lab.measure")->isEnabled());
}

TEST(LabStory, AnotherSceneOrAnEditFromElsewhereEndsWhatTheFiguresWereOf) {
  Lab story;
  story.measure();
  ASSERT_TRUE(story.walk()->isEnabled());
  ASSERT_TRUE(story.perform("gains.set", "kp", "x", 0.3));
  story.settle();
  EXPECT_TRUE(story.text("told").contains("Measure again"));
  EXPECT_FALSE(story.walk()->isEnabled());
  ASSERT_TRUE(story.perform("edit.undo"));
  story.measure();
  ASSERT_TRUE(story.walk()->isEnabled());
  const int rate_hz = story.host().rateHz();
  ASSERT_TRUE(story.perform("lab.walk", 0));  // the cheapest way: a lower rate
  ASSERT_LT(story.host().rateHz(), rate_hz);
  story.window().document().undoStack().setClean();
  ASSERT_TRUE(story.perform("scene.open", shippedScene("02_sphere")));
  story.settle();
  EXPECT_EQ(story.host().rateHz(), rate_hz) << "a rate that was tried goes with the scene that it was tried on";
  EXPECT_TRUE(story.text("told").contains("Nothing has been measured yet"));
  EXPECT_FALSE(story.walk()->isEnabled());
}

TEST(LabStory, ARateThatIsRefusedIsSaid) {
  Lab story;
  story.measure();
  story.host().record(std::make_shared<servo::Tap>(1'000'000));
  EXPECT_FALSE(story.perform("lab.walk", 0));
  EXPECT_EQ(story.host().rateHz(), 1000);
  EXPECT_TRUE(story.text("told").contains("The rate stays at 1000 Hz"));
  EXPECT_TRUE(story.text("told").contains("Stop the recording"));
  story.host().endRecord();
  EXPECT_TRUE(story.perform("lab.walk", 0));
  EXPECT_FALSE(story.text("told").contains("stays"));
}

TEST(LabStory, AMeshThatHoldsFromBothSidesOffersASearchAndAWallNone) {
  Lab story("26_bumpy_sphere");
  ASSERT_TRUE(QTest::qWaitFor([&] { return story.window().document().isOpen(); }, 60'000));
  story.settle();
  const QString search = "panel.lab.choice.search.value";
  EXPECT_EQ(story.window().findChild<QLabel*>(search), nullptr) << "a proxy follows the surface; nothing is sought";
  EXPECT_NE(story.window().findChild<QLabel*>("panel.lab.choice.velocity.value"), nullptr);  // a PD law
  scene::Description both = story.scene();
  both.constraints.front().side = target::Side::Both;
  ASSERT_TRUE(story.window().document().edit(both, "side", story.window().document().newGesture()).empty());
  story.settle();
  ASSERT_NE(story.window().findChild<QLabel*>(search), nullptr);
  EXPECT_EQ(story.text("choice.search.value"), "Search: hybrid");
}

TEST(LabStory, ItIsReadableInLightAndDarkAndInASmallWindow) {
  Lab story("05_circle");
  story.measure("sweep", 0.5);
  ASSERT_TRUE(story.perform("lab.walk", 0.5));
  story.savePicture("lab");
  const QImage light = story.find<MarkChart>("panel.lab.chart")->grab().toImage();
  ASSERT_TRUE(story.perform("view.theme.dark"));
  story.settle();
  story.savePicture("lab_dark");
  EXPECT_GT(worstBlockDifference(story.find<MarkChart>("panel.lab.chart")->grab().toImage(), light), 0.1);
  story.window().resize(1024, 700);
  story.settle();
  story.savePicture("lab_small");
  EXPECT_LE(story.window().width(), 1024);
}

// To be looked at by people: build/.../pictures/window_lab_2.png.
TEST(LabStory, NoTextIsCutAtTheUsualSizeNorAtTwiceIt) {
  const QFont default_value = QApplication::font();
  QFont large = default_value;
  large.setPointSizeF(2.0 * default_value.pointSizeF());
  for (const QFont& font : {default_value, large}) {
    QApplication::setFont(font);
    Lab story("12_line_pid", {.size = font == default_value ? QSize(1024, 700) : QSize(1920, 1080)});
    story.measure("sweep", 0.2);
    ASSERT_TRUE(story.perform("lab.walk", 0));
    story.settle();
    for (const QLabel* label : story.find("panel.lab")->findChildren<QLabel*>()) {
      if (label->text().isEmpty() || !label->isVisible()) continue;
      const std::string what = label->objectName().toStdString() + ": " + label->text().toStdString();
      if (label->wordWrap())
        EXPECT_GE(label->height(), label->heightForWidth(label->width())) << what;
      else
        EXPECT_GE(label->width(), label->sizeHint().width()) << what;
    }
    EXPECT_TRUE(story.picture().save(
        QString("%1/pictures/window_lab_%2.png").arg(UNDERACT_BINARY).arg(font == default_value ? 1 : 2)));
  }
  QApplication::setFont(default_value);
}

}  // namespace underact::gui::test
