#include "app/gui/window/window_watch.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QDialog>
#include <QPushButton>
#include <QTest>
#include <array>

#include "app/gui/arms/second_arm.h"
#include "app/gui/kit/stop_key.h"
#include "tests/gui/desk.h"
#include "tests/gui/person.h"
#include "tests/support/comes.h"

namespace underact::gui::test {
namespace {

using underact::test::comes;

/// A window that has the keyboard, a servo that pushes, and who watches both.
struct Watched {
  explicit Watched(bool arm_is_real, double limit_s = 1000.0)
      : desk(FeatureRow{}),
        is_real(arm_is_real),
        key([this] { desk.perform("session.stop"); }, [this] { return is_real; }, &desk.window()),
        button("Stop", &desk.window()) {
    button.setProperty(StopKey::kStops, true);
    button.setGeometry(100, 100, 80, 40);
    desk.show();
    desk.window().activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&desk.window()));
    watch = std::make_unique<WindowWatch>(desk.host(), *desk.services().second, key, limit_s);
    EXPECT_TRUE(watch->hears());
    QTest::qWait(200);  // it turns a few times
    desk.perform("session.start");
    desk.run(1);
    EXPECT_TRUE(desk.host().running());
  }
  void open(QDialog& dialog) const {
    dialog.open();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&dialog));
    QTest::qWait(100);
  }
  /// This thread, which is the window's, does nothing else meanwhile.
  bool stopsWhileBusy() {
    return comes([this] { return !desk.host().running(); });
  }
  /// Whether it is still running after all that was pressed has been heard.
  bool goesOn() {
    QTest::qWait(300);
    return desk.host().running();
  }

  Desk desk;
  bool is_real;
  StopKey key;
  QPushButton button;
  Person person;
  std::unique_ptr<WindowWatch> watch;
};

}  // namespace

TEST(WindowWatch, WhileTheWindowIsBusyEscStopsARealArmAndWhereNothingIsOpenAndShiftEscAlways) {
  for (const auto& [is_real, is_open, has_shift] :
       {std::array{true, true, false}, {false, false, false}, {false, true, true}}) {
    SCOPED_TRACE(is_real ? "real" : has_shift ? "Shift" : "simulated");
    Watched watched(is_real);
    QDialog dialog(&watched.desk.window());
    if (is_open) watched.open(dialog);
    has_shift ? watched.person.pressWithShift(Person::kEscape) : watched.person.press(Person::kEscape);
    EXPECT_TRUE(watched.stopsWhileBusy());
  }
}

TEST(WindowWatch, WithTheSimulatedArmAnOpenDialogGetsEscEvenIfItHasToWait) {
  Watched watched(false);
  QDialog dialog(&watched.desk.window());
  watched.open(dialog);
  watched.person.press(Person::kEscape);
  QThread::msleep(200);  // busy
  EXPECT_TRUE(watched.goesOn());
  EXPECT_FALSE(dialog.isVisible());
  watched.person.press(Person::kEscape);
  EXPECT_FALSE(watched.goesOn()) << "nothing is open any more";
}

TEST(WindowWatch, AClickOnStopStopsWhileTheWindowIsBusyAndOneBesideItDoesNot) {
  Watched watched(false);
  watched.person.click(watched.button.mapToGlobal(QPoint(-20, 20)));
  EXPECT_TRUE(watched.goesOn());
  watched.person.click(watched.button.mapToGlobal(QPoint(40, 20)));
  EXPECT_TRUE(watched.stopsWhileBusy());
}

TEST(WindowWatch, EscInAnotherProgramIsNoneOfOurs) {
  Watched watched(true);
  watched.person.takeKeyboard();
  watched.person.press(Person::kEscape);
  EXPECT_TRUE(watched.goesOn());
}

TEST(WindowWatch, AWindowThatStandsStillWhileItPushesEndsTheForceAndSaysSoAfterwards) {
  Watched watched(false, 0.4);
  QThread::msleep(1500);
  watched.desk.run(1);
  EXPECT_EQ(watched.desk.host().snapshot().mode, servo::Mode::Faulted);
  EXPECT_EQ(watched.desk.host().snapshot().report.fault.kind, FaultKind::WindowBusy);
  EXPECT_FALSE(watched.desk.host().running());
}

TEST(WindowWatch, ADialogThatWaitsForAnAnswerIsNotBusy) {
  Watched watched(false, 1.0);
  QDialog dialog(&watched.desk.window());
  QTimer::singleShot(2500, &dialog, &QDialog::accept);
  dialog.exec();
  watched.desk.run(1);
  EXPECT_TRUE(watched.desk.host().running());
}

TEST(WindowWatch, StopsTheSecondArmAsWell) {
  Watched watched(true);
  watched.desk.services().second->setOn(true);
  SecondArm& second = *watched.desk.services().second;
  ASSERT_TRUE(QTest::qWaitFor([&second] {
    second.poll();
    return !second.isLoading();
  }));
  second.start();
  second.run(1);
  ASSERT_TRUE(second.servo().running());
  watched.person.press(Person::kEscape);
  EXPECT_TRUE(comes([&second] { return !second.servo().running(); }));
  second.setOn(false);
  watched.person.press(Person::kEscape);  // with nobody there
  EXPECT_TRUE(watched.stopsWhileBusy());
}

}  // namespace underact::gui::test
