#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTableWidget>
#include <atomic>
#include <cmath>

#include "app/gui/identify/identify_tool.h"
#include "app/gui/identify/identify_wizard.h"
#include "app/gui/identify/swing_plot.h"
#include "core/scene/edit.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

using State = IdentifyRun::State;

constexpr int kMostSeconds = 60;  // of the arm; a measurement takes 34

void save(QWidget* what, const QString& name) {
  QTest::qWait(150);
  EXPECT_TRUE(what->grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/" + name + ".png"));
}

/// A window with the wizard open on its first page, the servo running on the sphere.
struct Bench : Story {
  explicit Bench(const Beginning& beginning = {}) : Story("02_sphere", beginning) {
    perform("session.start");
    run(500);
    EXPECT_TRUE(perform("identify.open"));
    settle();
  }
  Document& document() { return window().document(); }
  IdentifyWizard* wizard() { return window().findChild<IdentifyWizard*>(); }
  const IdentifyRun& measuring() { return window().findChild<IdentifyTool*>()->run(); }
  template <class Widget = QAbstractButton>
  Widget* in(const QString& name) {
    auto* found = wizard()->findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name.toStdString();
    return found;
  }
  void press(const QString& name) {
    ASSERT_TRUE(in(name)->isVisible() && in(name)->isEnabled()) << name.toStdString();
    in(name)->click();
  }
  void beginMeasuring() {
    press("identify.next");
    press("identify.next");
  }
  void runTo(State state) {
    for (int second = 0; second < kMostSeconds && measuring().state() != state; ++second) run(host().rateHz());
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          window().frame();
          return measuring().state() == state;
        },
        20'000));
  }
  void measure() {
    beginMeasuring();
    runTo(State::Evaluates);
    runTo(State::Done);
  }
};

QString cell(const QTableWidget* table, const QString& quantity, int column) {
  for (int row = 0; row < table->rowCount(); ++row) {
    if (table->item(row, 0)->text() == quantity) return table->item(row, column)->text();
  }
  ADD_FAILURE() << "no row " << quantity.toStdString();
  return {};
}

void expectNear(const QTableWidget* table, const QString& quantity, double given) {
  EXPECT_NEAR(cell(table, quantity, 1).toDouble(), given, 0.05 * given) << quantity.toStdString();
}

}  // namespace

TEST(IdentifyStory, TheWizardFindsWhatTheSimulatedArmIsMadeOfAndEndsWithAFile) {
  Bench bench;
  const scene::Description before = bench.host().scene();
  const Vec3 wished_W = bench.arm().wished().p_WT;
  ASSERT_NE(bench.wizard(), nullptr);
  EXPECT_FALSE(bench.wizard()->isModal()) << "Esc must stop the arm, whatever is open";
  save(bench.wizard(), "identify_intro");
  bench.press("identify.next");
  save(bench.wizard(), "identify_place");
  bench.press("identify.next");
  EXPECT_EQ(bench.measuring().state(), State::Asks);
  bench.run(6000);
  EXPECT_EQ(bench.measuring().state(), State::Runs);
  EXPECT_FALSE(bench.in("identify.next")->isEnabled());
  EXPECT_TRUE(bench.document().isTryingOut());
  EXPECT_GT(bench.in<QProgressBar>("identify.progress")->value(), 100);
  EXPECT_TRUE(bench.in<QLabel>("identify.stage")->text().contains("Swings along x"));
  EXPECT_TRUE(bench.in<QLabel>("identify.prompt")->text().contains("simulated hand"));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        bench.run(16);
        return !bench.measuring().picture().fit.empty();
      },
      10'000))
      << "a fit beside the swings while they are made";
  save(bench.wizard(), "identify_running");
  bench.runTo(State::Evaluates);
  bench.runTo(State::Done);
  bench.settle();
  EXPECT_TRUE(bench.in<QWidget>("identify.found")->isVisible());
  auto* const table = bench.in<QTableWidget>("identify.table");
  for (const char* axis : {"", " along x", " along y", " along z"}) {
    expectNear(table, QString("Mass") + axis, 45.0);
    expectNear(table, QString("Friction") + axis, 0.26);
  }
  EXPECT_TRUE(cell(table, "Damping", 1).startsWith("below 0.0") ||
              std::abs(cell(table, "Damping", 1).toDouble()) < 0.01);
  expectNear(table, "Counts a turn, turret", 15280.0);
  expectNear(table, "Counts a turn, gimbal 3", 4915.0);
  expectNear(table, "Stiffness in a slow press", 0.5);
  expectNear(table, "Linear until the clamp, at", 1.76);
  EXPECT_EQ(bench.in<QComboBox>("identify.which")->count(), 3);
  save(bench.wizard(), "identify_found");
  // The scene from before is in effect again, and nothing of it all is an edit.
  EXPECT_TRUE(scene::isSame(bench.host().scene(), before));
  EXPECT_FALSE(bench.document().isTryingOut());
  EXPECT_FALSE(bench.document().modified());
  EXPECT_EQ(bench.arm().wished().p_WT, wished_W) << "the hand wants what it wanted before";
  bench.run(1000);
  EXPECT_EQ(bench.snapshot().mode, servo::Mode::Running);
  EXPECT_GT(bench.snapshot().report.level, 0.99);

  bench.press("identify.next");
  bench.in<QLineEdit>("identify.name")->setText("bench-3");
  save(bench.wizard(), "identify_keep");
  const QString path = temporaryFile("bench-3.json"), report = temporaryFile("bench-3.md");
  ASSERT_TRUE(bench.perform("identify.save", path));
  ASSERT_TRUE(bench.perform("identify.report", report));
  EXPECT_FALSE(bench.perform("identify.save", QString("/nowhere/at/all.json")));
  EXPECT_TRUE(bench.in<QLabel>("identify.told")->text().contains("could not be written"));
  const Result<sim::ArmModelFile> file = sim::readArmModelFile(path.toStdString());
  ASSERT_TRUE(static_cast<bool>(file));
  EXPECT_EQ(file.value().arm.name, "bench-3");
  EXPECT_NEAR(file.value().arm.mass_kg, 0.045, 0.05 * 0.045);
  EXPECT_NEAR(file.value().arm.friction_N, 0.26, 0.05 * 0.26);
  EXPECT_EQ(file.value().provenance.rate_hz, 1000);
  QFile text(report);
  ASSERT_TRUE(text.open(QIODevice::ReadOnly));
  EXPECT_TRUE(text.readAll().contains("| Mass along z |"));
}

TEST(IdentifyStory, AMeasuredArmIsUsedShownRememberedAndGivenBack) {
  const QString path = temporaryFile("heavy.json", R"({"underact_arm_model": 1, "name": "heavy", "title": "Heavy",
    "provenance": {"device": "a bench", "date": "2026-11-22"},
    "mass_kg": 0.2, "friction_N": 0.1, "damping_N_s_per_m": 1.0})");
  {
    Bench bench;
    EXPECT_FALSE(bench.window().actions().find("arm.vendor")->isEnabled());
    ASSERT_TRUE(bench.perform("arm.open", path));
    EXPECT_EQ(bench.find<QLabel>("status.device")->text(), "Simulated arm: heavy");
    EXPECT_TRUE(bench.find<QLabel>("status.device")->toolTip().contains("Measured on a bench, on 2026-11-22"));
    bench.measure();  // it is that arm which is found
    auto* const table = bench.in<QTableWidget>("identify.table");
    expectNear(table, "Mass", 200.0);
    expectNear(table, "Friction", 0.1);
    expectNear(table, "Damping", 1.0);
    EXPECT_EQ(cell(table, "Mass", 4), "200");
    bench.press("identify.next");
    bench.in<QLineEdit>("identify.name")->setText("again");
    bench.press("identify.use");
    EXPECT_EQ(bench.find<QLabel>("status.device")->text(), "Simulated arm: again");
    EXPECT_TRUE(bench.in<QLabel>("identify.told")->text().contains("now"));
    bench.press("identify.finish");
    bench.settle();
    bench.savePicture("identify_arm_in_use");
  }
  Story next("02_sphere", {.first_start = false});
  EXPECT_EQ(next.find<QLabel>("status.device")->text(), "Simulated arm: again");
  ASSERT_TRUE(next.perform("arm.vendor"));
  EXPECT_EQ(next.find<QLabel>("status.device")->text(), "Simulated arm");
  EXPECT_FALSE(next.window().actions().find("arm.vendor")->isEnabled());
  EXPECT_EQ(next.window().findChild<ArmInUse*>()->model().mass_kg, 0.045);
}

TEST(IdentifyStory, AFileThatIsNoArmIsRefusedInWordsAndTheArmStays) {
  Story story("02_sphere");
  const QString path = temporaryFile("no_arm.json", R"({"underact_arm_model": 1, "mass": 2})");
  EXPECT_FALSE(story.perform("arm.open", path));
  story.settle();
  EXPECT_NE(story.window().findChild<QWidget*>("dialog.arm_problems"), nullptr);
  EXPECT_EQ(story.find<QLabel>("status.device")->text(), "Simulated arm");
}

TEST(IdentifyStory, CancellingPutsSceneAndHandBack) {
  Bench bench;
  const scene::Description before = bench.host().scene();
  bench.beginMeasuring();
  bench.run(9000);
  ASSERT_EQ(bench.measuring().state(), State::Runs);
  EXPECT_FALSE(scene::isSame(bench.host().scene(), before));
  bench.press("identify.cancel");
  bench.settle();
  EXPECT_EQ(bench.measuring().state(), State::Idle);
  EXPECT_TRUE(scene::isSame(bench.host().scene(), before));
  bench.run(2000);
  EXPECT_EQ(bench.snapshot().mode, servo::Mode::Running);
  sim::HandWish wish;  // the hand holds the stylus again
  wish.p_WT = Vec3(0.0, 0.0, 0.07);
  bench.arm().wish(wish);
  bench.run(2000);
  EXPECT_GT(bench.snapshot().report.p_WT.z(), 0.055);
}

TEST(IdentifyStory, EscStopsTheServoAndASceneThatIsEditedMeanwhileStopsTheMeasurement) {
  Bench bench;
  bench.beginMeasuring();
  bench.run(5000);
  bench.bringToFront(bench.wizard());
  bench.key(Qt::Key_Escape);
  bench.run(100);
  EXPECT_EQ(bench.snapshot().report.force.f_T_W().norm(), 0.0);
  EXPECT_EQ(bench.measuring().state(), State::Stopped);
  EXPECT_TRUE(bench.in<QLabel>("identify.why")->text().contains("stopped"));
  bench.press("identify.repeat");
  bench.run(1000);
  EXPECT_EQ(bench.measuring().state(), State::Runs);
  scene::Description edited = bench.document().scene();
  edited.control.gains.kp_N_per_mm.setConstant(0.3);
  ASSERT_TRUE(bench.document().edit(edited, "stiffness", bench.document().newGesture()).empty());
  bench.run(100);
  EXPECT_EQ(bench.measuring().state(), State::Stopped);
  EXPECT_TRUE(bench.in<QLabel>("identify.why")->text().contains("changed"));
  save(bench.wizard(), "identify_stopped");
  bench.press("identify.repeat");  // the edited scene is the one that is put back now
  bench.run(1000);
  bench.press("identify.cancel");
  bench.settle();
  EXPECT_EQ(bench.measuring().state(), State::Idle);
  EXPECT_TRUE(scene::isSame(bench.host().scene(), edited));
}

TEST(IdentifyStory, ItSaysWhyItCannotBegin) {
  Bench bench;
  bench.press("identify.next");
  bench.in<QDoubleSpinBox>("identify.place.y")->setValue(190.0);
  bench.press("identify.next");
  EXPECT_EQ(bench.measuring().state(), State::Idle);
  EXPECT_TRUE(bench.in<QLabel>("identify.why")->text().contains("nearer to the middle"));
  EXPECT_TRUE(bench.in("identify.repeat")->isVisible());
  bench.press("identify.back");
  bench.in<QDoubleSpinBox>("identify.place.y")->setValue(0.0);
  ASSERT_TRUE(bench.perform("session.hold_to_run", true));
  bench.press("identify.next");
  EXPECT_TRUE(bench.in<QLabel>("identify.why")->text().contains("Hold to run"));
  ASSERT_TRUE(bench.perform("session.hold_to_run", false));
  bench.press("identify.repeat");
  bench.run(500);
  EXPECT_EQ(bench.measuring().state(), State::Runs);
}

namespace {

// An arm that is none of the window's simulated ones: its cable can be pulled, and its hand lets go.
class PulledCable final : public servo::DevicePort {
 public:
  explicit PulledCable(std::atomic<bool>& plugged_in) : arm_(simulatedArmOptions(1000)), plugged_in_(plugged_in) {
    arm_.holdStylus(false);
  }
  bool read(arm::Sample& sample) noexcept override { return arm_.read(sample) && plugged_in_.load(); }
  void write(const safety::GatedForce& force) noexcept override { arm_.write(force); }
  void cut() noexcept override { arm_.cut(); }
  servo::DeviceInfo info() const override { return {"Arm on a cable", false, true}; }

 private:
  device::SimulatedArm arm_;
  std::atomic<bool>& plugged_in_;
};

}  // namespace

TEST(IdentifyStory, OnAnotherArmItAsksThePersonAndAFaultMidwayIsTakenUpAgain) {
  forgetSettings();
  std::atomic<bool> plugged_in{true};
  servo::Host host(std::make_unique<PulledCable>(plugged_in), {.clock = servo::Clock::Manual});
  ThemeWatcher theme;
  MainWindow window({host, nullptr, theme});
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  window.actions().perform("scene.open", shippedScene("02_sphere"));
  const auto run = [&](int ticks) {
    for (int done = 0; done < ticks; done += 16) {
      host.run(16);
      window.frame();
    }
  };
  ASSERT_TRUE(window.actions().perform("identify.open"));
  auto* const wizard = window.findChild<IdentifyWizard*>();
  const IdentifyRun& measuring = window.findChild<IdentifyTool*>()->run();
  const auto in = [wizard](const char* name) { return wizard->findChild<QAbstractButton*>(name); };
  in("identify.next")->click();
  in("identify.next")->click();
  run(500);
  EXPECT_EQ(measuring.state(), State::Asks) << "nothing moves before the person says so";
  EXPECT_FALSE(host.running());
  ASSERT_TRUE(in("identify.go")->isVisible());
  EXPECT_TRUE(wizard->findChild<QLabel*>("identify.prompt")->text().startsWith("Let go"));
  in("identify.go")->click();
  run(10'000);
  ASSERT_EQ(measuring.state(), State::Runs);
  const double share = measuring.share();
  plugged_in = false;
  run(100);
  plugged_in = true;
  EXPECT_EQ(measuring.state(), State::Stopped);
  EXPECT_TRUE(wizard->findChild<QLabel*>("identify.why")->text().contains("stopped answering"))
      << wizard->findChild<QLabel*>("identify.why")->text().toStdString();
  save(wizard, "identify_fault");
  ASSERT_TRUE(in("identify.repeat")->isVisible());
  in("identify.repeat")->click();
  run(100);
  EXPECT_EQ(measuring.state(), State::Runs);
  EXPECT_LT(measuring.share(), share);
  for (int second = 0; second < kMostSeconds && measuring.state() != State::Evaluates; ++second) {
    if (measuring.state() == State::Asks) in("identify.go")->click();
    run(1000);
  }
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        window.frame();
        return measuring.state() == State::Done;
      },
      20'000));
  auto* const table = wizard->findChild<QTableWidget*>("identify.table");
  expectNear(table, "Mass", 45.0);
  expectNear(table, "Friction", 0.26);
  EXPECT_TRUE(table->isColumnHidden(5)) << "nobody knows what a real arm is made of";
  EXPECT_TRUE(wizard->findChild<QLabel*>("identify.found.what")->text().contains("was not pressed"));
  in("identify.next")->click();
  EXPECT_FALSE(in("identify.use")->isVisible());
  EXPECT_TRUE(wizard->findChild<QLabel*>("identify.provenance")->text().contains("Arm on a cable"));
  EXPECT_FALSE(host.running()) << "it stood still before, too";
  window.close();
}

TEST(IdentifyStory, ItLooksRightInDarkOnALargeScreenAndWithLargeText) {
  const QFont usual = QApplication::font();
  for (const double share : {1.0, 2.0}) {
    QFont font = usual;
    font.setPointSizeF(share * usual.pointSizeF());
    QApplication::setFont(font);
    Bench bench({.size = share > 1.0 ? QSize(1280, 800) : QSize(1920, 1080)});
    bench.perform("view.theme.dark");
    bench.measure();
    bench.settle();
    EXPECT_LE(bench.wizard()->height(), bench.window().height());
    for (const char* name : {"identify.next", "identify.cancel", "identify.table", "identify.which"}) {
      auto* const widget = bench.in<QWidget>(name);
      const QRect there(widget->mapTo(bench.wizard(), QPoint()), widget->size());
      EXPECT_TRUE(bench.wizard()->rect().contains(there)) << name << " at " << share;
      EXPECT_GE(widget->height(), widget->minimumSizeHint().height()) << name << " at " << share;
    }
    EXPECT_LT(bench.in<SwingPlot>("identify.found.plot")->picture().pixelColor(3, 3).lightness(), 80);
    save(bench.wizard(), share > 1.0 ? "identify_dark_large_text" : "identify_dark");
  }
  QApplication::setFont(usual);
}

}  // namespace underact::gui::test
