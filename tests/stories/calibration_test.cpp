#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QProcess>
#include <QProgressBar>
#include <QSpinBox>
#include <cmath>

#include "app/gui/calibration/calibration_run.h"
#include "app/gui/calibration/staircase_chart.h"
#include "core/scene/edit.h"
#include "core/scene/read.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

using calibration::Beam;
using State = CalibrationRun::State;

/// A window with the panel open on the two beams, the servo running.
struct CalibrationLab : Story {
  explicit CalibrationLab(const Beginning& beginning = {}, const QString& scene = "23_two_beams")
      : Story(scene, beginning) {
    EXPECT_TRUE(perform("dock.calibration", true));
    perform("session.start");
    run(500);
    settle();
  }
  const CalibrationRun& session() { return *window().findChild<CalibrationRun*>(); }
  QString text(const QString& name) { return find<QLabel>("panel.calibration." + name)->text(); }
  QAbstractButton* button(const QString& name) { return find<QAbstractButton>("panel.calibration." + name); }
  void holdAt(const Vec3& p_W, int ticks) {
    sim::HandSetpoint setpoint;
    setpoint.p_WT = p_W;
    arm().setSetpoint(setpoint);
    run(ticks);
  }
  void press(Beam beam) {  // from rest, 6 mm down, and back
    const Vec3 p_WT = calibration::tipOf(window().document().scene(), beam);
    holdAt(p_WT, 1500);
    holdAt(p_WT - 0.006 * Vec3::UnitY(), 1500);
    holdAt(p_WT, 1000);
  }
  void pressBoth() {
    press(Beam::Left);
    press(Beam::Right);
  }
  void choose(bool simulated, int seed) {
    find<QComboBox>("panel.calibration.who")->setCurrentIndex(simulated ? 1 : 0);
    find<QSpinBox>("panel.calibration.seed")->setValue(seed);
  }
  /// The whole of a simulated hand's run.
  void measure(int seed) {
    choose(true, seed);
    click(button("begin"));
    EXPECT_TRUE(QTest::qWaitFor([this] { return session().state() == State::Done; }, 60000));
  }
};

Beam other(Beam beam) {
  return beam == Beam::Left ? Beam::Right : Beam::Left;
}

QString action(Beam beam) {
  return QString("calibration.") + name(beam);
}

/// What the command line says of the same scene.
QJsonObject calibrateCommand(const QStringList& more) {
  QProcess program;
  program.start(UNDERACT_CLI, QStringList{"calibrate", shippedScene("23_two_beams")} + more);
  EXPECT_TRUE(program.waitForFinished(60000));
  EXPECT_EQ(program.exitCode(), 0);
  return QJsonDocument::fromJson(program.readAllStandardOutput()).object();
}

}  // namespace

TEST(CalibrationStory, AnotherSceneIsToldToHaveNoBeamsAndAButtonOpensThem) {
  CalibrationLab story({}, "02_sphere");
  EXPECT_TRUE(story.button("open")->isVisible());
  EXPECT_FALSE(story.perform("calibration.begin"));
  story.click(story.button("open"));
  EXPECT_EQ(story.window().document().path(), shippedScene("23_two_beams"));
  EXPECT_FALSE(story.button("open")->isVisible());
  EXPECT_TRUE(story.button("begin")->isVisible());
  EXPECT_NEAR(story.find<QDoubleSpinBox>("panel.calibration.reference")->value(), 0.03, 1e-9);
}

TEST(CalibrationStory, TheSimulatedHandFindsWhatTheCommandLineFinds) {
  CalibrationLab story;
  story.find<QDoubleSpinBox>("panel.calibration.weber")->setValue(20.0);
  const std::uint64_t revision = story.host().revision();
  story.measure(7);
  const QJsonObject wanted = calibrateCommand({"--seed", "7", "--weber", "0.2"});
  const calibration::Measurement& run = story.session().run();
  const auto threshold = thresholdOf(run.staircase);
  ASSERT_TRUE(threshold);
  EXPECT_EQ(threshold->difference, wanted["threshold"].toDouble());
  EXPECT_EQ(threshold->high, wanted["high"].toDouble());
  const QJsonArray trials = wanted["trials"].toArray();
  ASSERT_EQ(static_cast<qsizetype>(run.answers.size()), trials.size());
  for (std::size_t index = 0; index < run.answers.size(); ++index) {
    const QJsonObject trial = trials[static_cast<qsizetype>(index)].toObject();
    EXPECT_EQ(trial["answer"].toString(), QString(name(run.answers[index].answer))) << index;
    EXPECT_EQ(trial["stiffer"].toString(), QString(name(run.answers[index].trial.stiffer))) << index;
  }
  EXPECT_EQ(story.host().revision(), revision);  // it never touched the window's servo
  EXPECT_TRUE(story.text("result.0").startsWith(QString::number(100.0 * threshold->difference, 'f', 1)))
      << story.text("result.0").toStdString();
  EXPECT_EQ(story.text("result.4"), QString::number(trials.size()));
}

TEST(CalibrationStory, TheWindowLivesWhileTheSimulatedHandPressesAndCancelEndsIt) {
  CalibrationLab story;
  story.choose(true, 1);
  story.click(story.button("begin"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return story.session().run().answers.size() >= 3; }, 60000));
  EXPECT_TRUE(story.button("cancel")->isVisible());
  EXPECT_FALSE(story.button("left")->isVisible());
  EXPECT_FALSE(story.perform("calibration.left"));  // it is not the person who is asked
  story.click(story.button("cancel"));
  EXPECT_EQ(story.session().state(), State::Idle);
  const std::size_t answers = story.session().run().answers.size();
  story.settle(200);
  EXPECT_EQ(story.session().run().answers.size(), answers);
}

TEST(CalibrationStory, APersonAnswersOnceBothBeamsWerePressed) {
  CalibrationLab story;
  story.choose(false, 3);
  story.click(story.button("begin"));
  ASSERT_EQ(story.session().state(), State::Running);
  EXPECT_FALSE(story.button("left")->isEnabled());
  EXPECT_FALSE(story.perform("calibration.left"));
  story.press(Beam::Left);
  EXPECT_EQ(story.text("left.pressed"), "✓ pressed");
  EXPECT_EQ(story.text("right.pressed"), "press it");
  EXPECT_FALSE(story.button("right")->isEnabled());
  story.press(Beam::Right);
  EXPECT_TRUE(story.button("left")->isEnabled() && story.button("right")->isEnabled());
  for (const QLabel* label : story.find("panel.calibration")->findChildren<QLabel*>()) {
    EXPECT_FALSE(label->isVisible() && label->text().contains("N/mm")) << label->text().toStdString();
  }
  EXPECT_TRUE(story.perform(action(story.session().run().trial.stiffer)));
  EXPECT_TRUE(story.session().run().answers.at(0).isRight());
  EXPECT_FALSE(story.button("left")->isEnabled());  // the next trial is to be felt first
  EXPECT_FALSE(story.find("panel.calibration.said")->isVisible());
  EXPECT_TRUE(story.text("trial").contains("Trial 2"));
}

TEST(CalibrationStory, ABeamThatIsStillHeldFromTheTrialBeforeHasToBeLetGo) {
  CalibrationLab story;
  story.choose(false, 3);
  ASSERT_TRUE(story.perform("calibration.begin"));
  story.pressBoth();
  const Vec3 down = calibration::tipOf(story.window().document().scene(), Beam::Right) - 0.006 * Vec3::UnitY();
  story.holdAt(down, 1500);
  ASSERT_TRUE(story.perform("calibration.left"));
  story.run(1500);
  EXPECT_EQ(story.text("right.pressed"), "press it");
  story.pressBoth();
  EXPECT_TRUE(story.session().mayAnswer());
}

TEST(CalibrationStory, NothingIsPressedWhileTheServoIsStopped) {
  CalibrationLab story;
  story.choose(false, 3);
  story.perform("session.stop");
  story.run(1000);
  ASSERT_TRUE(story.perform("calibration.begin"));
  story.pressBoth();
  EXPECT_FALSE(story.session().isPressed(Beam::Left) || story.session().isPressed(Beam::Right));
  EXPECT_TRUE(story.text("hint").contains("Start")) << story.text("hint").toStdString();
}

TEST(CalibrationStory, APersonsWholeRunEndsWithTheScenesOwnStiffness) {
  CalibrationLab story;
  const scene::Description own = story.host().scene();
  story.choose(false, 3);
  story.button("feedback")->setChecked(true);
  ASSERT_TRUE(story.perform("calibration.begin"));
  for (int trial = 1; story.session().state() == State::Running && trial < 40; ++trial) {
    story.pressBoth();
    const Beam stiffer = story.session().run().trial.stiffer;
    EXPECT_FALSE(scene::isSame(story.host().scene(), own));  // the beams are those of the trial
    EXPECT_TRUE(scene::isSame(story.window().document().scene(), own));
    ASSERT_TRUE(story.perform(action(trial % 3 == 0 ? other(stiffer) : stiffer))) << trial;
    EXPECT_EQ(story.text("said").contains("It was the other"), trial % 3 == 0) << trial;
  }
  ASSERT_EQ(story.session().state(), State::Done);
  EXPECT_EQ(story.session().run().answers.size(), 17u);  // two right, one wrong: it turns at every step after the first
  EXPECT_TRUE(scene::isSame(story.host().scene(), own));
  EXPECT_EQ(story.window().document().undoStack().count(), 0);
  EXPECT_EQ(story.text("result.6"), "a person");
  story.click(story.button("again"));
  EXPECT_EQ(story.session().state(), State::Idle);
  EXPECT_TRUE(story.button("begin")->isVisible());
}

TEST(CalibrationStory, TheArrowKeysAnswerWhereThePanelHasTheFocus) {
  CalibrationLab story;
  story.choose(false, 3);
  story.click(story.button("begin"));
  story.key(Qt::Key_Left);  // too early
  EXPECT_TRUE(story.session().run().answers.empty());
  story.pressBoth();
  story.key(Qt::Key_Right);
  ASSERT_EQ(story.session().run().answers.size(), 1u);
  EXPECT_EQ(story.session().run().answers[0].answer, Beam::Right);
  story.pressBoth();
  story.key(Qt::Key_Left, Qt::AltModifier);
  ASSERT_EQ(story.session().run().answers.size(), 2u);
  EXPECT_EQ(story.session().run().answers[1].answer, Beam::Left);
  story.pressBoth();
  story.button("left")->setFocus(Qt::TabFocusReason);
  story.key(Qt::Key_Space);
  ASSERT_EQ(story.session().run().answers.size(), 3u);
  story.key(Qt::Key_Space);  // greyed now; the focus has not gone on to Cancel
  EXPECT_EQ(story.session().state(), State::Running);
}

TEST(CalibrationStory, CancelBringsTheScenesStiffnessBackAndLeavesUndoAlone) {
  CalibrationLab story;
  ASSERT_TRUE(story.perform("gains.set", "kp", "x", 0.4));
  const scene::Description own = story.host().scene();
  const int steps = story.window().document().undoStack().index();
  story.choose(false, 3);
  ASSERT_TRUE(story.perform("calibration.begin"));
  story.run(250);
  EXPECT_FALSE(scene::isSame(story.host().scene(), own));
  EXPECT_EQ(story.snapshot().report.level, 1.0);  // taken up without a ramp
  const QString tuned = temporaryFile("tuned.json");
  ASSERT_TRUE(story.perform("scene.save_as", tuned));
  EXPECT_TRUE(scene::isSame(scene::readSceneFile(tuned.toStdString()).value(), own));
  EXPECT_EQ(story.session().state(), State::Running);
  ASSERT_TRUE(story.perform("calibration.cancel"));
  EXPECT_TRUE(scene::isSame(story.host().scene(), own));
  EXPECT_EQ(story.window().document().undoStack().index(), steps);
  EXPECT_FALSE(story.perform("calibration.cancel"));
}

TEST(CalibrationStory, AnEditOrAnUndoCancelsAndKnowsNothingOfTheTrial) {
  CalibrationLab story;
  const scene::Description own = story.host().scene();
  story.choose(false, 3);
  ASSERT_TRUE(story.perform("calibration.begin"));
  ASSERT_TRUE(story.perform("gains.set", "kp", "x", 0.4));
  EXPECT_EQ(story.session().state(), State::Idle);
  EXPECT_TRUE(story.text("note").contains("changed")) << story.text("note").toStdString();
  EXPECT_NEAR(calibration::softerOf(story.host().scene()).value(), calibration::softerOf(own).value(), 1e-15);
  ASSERT_TRUE(story.perform("calibration.begin"));
  EXPECT_TRUE(story.perform("edit.undo"));
  EXPECT_EQ(story.session().state(), State::Idle);
  EXPECT_TRUE(scene::isSame(story.host().scene(), own));
}

TEST(CalibrationStory, AnotherSceneOrClosingTheWindowCancels) {
  CalibrationLab story;
  const scene::Description own = story.host().scene();
  story.choose(false, 3);
  ASSERT_TRUE(story.perform("calibration.begin"));
  ASSERT_TRUE(story.perform("scene.open", shippedScene("02_sphere")));
  EXPECT_EQ(story.session().state(), State::Idle);
  EXPECT_EQ(story.host().scene().title, story.window().document().scene().title);
  EXPECT_TRUE(story.button("open")->isVisible());
  story.run(500);
  ASSERT_TRUE(story.perform("scene.open", shippedScene("23_two_beams")));
  story.choose(true, 3);
  ASSERT_TRUE(story.perform("calibration.begin"));
  ASSERT_TRUE(story.perform("scene.open", shippedScene("23_two_beams")));
  EXPECT_EQ(story.session().state(), State::Idle);
  EXPECT_TRUE(story.text("note").contains("Another scene"));
  story.choose(false, 3);
  ASSERT_TRUE(story.perform("calibration.begin"));
  story.window().close();
  EXPECT_TRUE(scene::isSame(story.host().scene(), own));
}

TEST(CalibrationStory, SaveWritesEveryTrialAndSaysSo) {
  CalibrationLab story;
  EXPECT_FALSE(story.perform("calibration.save", temporaryFile("early.csv")));  // there is no result yet
  story.measure(3);
  const QString path = temporaryFile("jnd.csv");
  ASSERT_TRUE(story.perform("calibration.save", path));
  EXPECT_TRUE(story.text("saved").contains("jnd.csv"));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll().toStdString(),
            calibration::csvOf(story.session().run(), "a simulated hand with a Weber fraction of 0.15", 3));
  EXPECT_FALSE(story.perform("calibration.save", QString("/dev/null/nowhere/all.csv")));
  EXPECT_TRUE(story.text("saved").startsWith("Not saved"));
  story.click(story.button("save"));
  ASSERT_TRUE(QTest::qWaitFor([] { return QApplication::activeModalWidget() != nullptr; }));
  EXPECT_EQ(QApplication::activeModalWidget()->objectName(), "dialog.save_calibration");
  QApplication::activeModalWidget()->close();
}

TEST(CalibrationStory, WhatWasChosenIsRememberedAndAResetClosesThePanel) {
  {
    CalibrationLab story;
    story.choose(true, 42);
    story.find<QDoubleSpinBox>("panel.calibration.weber")->setValue(30.0);
    ASSERT_TRUE(story.perform("calibration.begin"));
  }
  Story story({}, {.first_start = false});
  EXPECT_TRUE(story.find("dock.calibration")->isVisible());
  EXPECT_EQ(story.find<QComboBox>("panel.calibration.who")->currentIndex(), 1);
  EXPECT_EQ(story.find<QSpinBox>("panel.calibration.seed")->value(), 42);
  EXPECT_EQ(story.find<QDoubleSpinBox>("panel.calibration.weber")->value(), 30.0);
  story.perform("layout.reset");
  EXPECT_FALSE(story.find("dock.calibration")->isVisible());
}

TEST(CalibrationStory, ThePictureOfTheResult) {
  CalibrationLab story;
  story.perform("view.theme.light");
  story.measure(3);
  auto* chart = story.find<MarkChart>("panel.calibration.chart");
  chart->setParent(nullptr);  // out of the dock, where the text decides how large it is
  QFont no_text = chart->font();
  no_text.setPixelSize(1);
  chart->setFont(no_text);
  chart->setPalette(paletteOf(Theme::light()));
  chart->setFixedSize(480, 320);
  EXPECT_LT(differenceFromReference(chart->grab().toImage(), "calibration_result"), kTolerance);
  delete chart;
}

// To be looked at by people: build/.../pictures/window_calibration_*.png.
TEST(CalibrationStory, NoTextIsCutAtTheUsualSizeNorAtTwiceIt) {
  const QFont default_value = QApplication::font();
  for (const double share : {1.0, 2.0}) {
    QFont font = default_value;
    font.setPointSizeF(share * default_value.pointSizeF());
    QApplication::setFont(font);
    {
      CalibrationLab story({.size = share > 1.5 ? QSize(1920, 1080) : QSize(1280, 800)});
      story.perform(share > 1.5 ? "view.theme.dark" : "view.theme.light");
      const auto look = [&](const char* what) {
        story.settle();
        for (const QWidget* widget : story.find("panel.calibration")->findChildren<QWidget*>()) {
          const auto* label = qobject_cast<const QLabel*>(widget);
          const bool is_text = label != nullptr && !label->wordWrap() && !label->text().isEmpty();
          if (!widget->isVisible() || !(is_text || qobject_cast<const QAbstractButton*>(widget))) continue;
          EXPECT_GE(widget->width(), widget->minimumSizeHint().width()) << widget->objectName().toStdString();
          EXPECT_GE(widget->height(), widget->minimumSizeHint().height()) << widget->objectName().toStdString();
        }
        const QString file = QString("%1/pictures/window_calibration_%2_%3.png").arg(UNDERACT_BINARY, what).arg(share);
        EXPECT_TRUE(story.picture().save(file));
      };
      look("begin");
      story.choose(false, 3);
      ASSERT_TRUE(story.perform("calibration.begin"));
      story.press(Beam::Left);
      look("person");
      story.perform("calibration.cancel");
      story.measure(3);
      look("result");
    }
  }
  QApplication::setFont(default_value);
}

}  // namespace underact::gui::test
