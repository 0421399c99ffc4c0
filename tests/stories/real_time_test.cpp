#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QRegularExpression>
#include <cmath>
#include <cstdio>

#include "tests/stories/story.h"
#include "tests/support/resident_memory.h"

namespace underact::gui::test {
namespace {

// Lateness p99 of the servo over a while in which the window does what `each` says, 20 times a second.
double latenessWhile(Story& story, const std::function<void(int)>& each) {
  servo::Histogram lateness;
  for (int step = 0; step < 60; ++step) {
    each(step);
    QTest::qWait(50);
    lateness.add(story.snapshot().lateness_ns);
  }
  return lateness.percentiles().p99_us;
}

// With software GL, which takes more than half of it.
constexpr double kMaxWithOneScene_MB = 240.0;
constexpr double kMoreOfMesa25_MB = 40.0;  // Debian 13's driver, see figures.md; Debian 12's is within the bound

}  // namespace

TEST(RealTimeStory, LoadingScenesAndResizingTheWindowDropsNoTickAndStopsNothing) {
  Story story("02_sphere", {.servo = {.clock = servo::Clock::Thread}});
  story.perform("session.start");
  const double still_us = latenessWhile(story, [](int) {});
  const double busy_us = latenessWhile(story, [&story](int step) {
    story.window().resize(1100 + 5 * step, 720 + step);
    if (step % 10 == 0) story.perform("scene.open", shippedScene(step % 20 == 0 ? "06_cylinder" : "02_sphere"));
  });
  // A number for the reader: on a machine that others share it says more of them than of the window.
  std::printf("lateness p99: %.0f us at rest, %.0f us while loading and resizing\n", still_us, busy_us);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  EXPECT_EQ(story.snapshot().dropped, 0);
  EXPECT_GT(story.view().framesDrawn(), 2);
  EXPECT_TRUE(story.find<QLabel>("status.rate")->text().endsWith("Hz") ||
              story.find<QLabel>("status.rate")->text().contains("of 1000"));
}

TEST(RealTimeStory, TheViewFollowsTheHand) {
  Story story("02_sphere", {.servo = {.clock = servo::Clock::Thread}});
  story.perform("session.start");
  const qint64 before = story.view().framesDrawn();
  QElapsedTimer clock;
  clock.start();
  for (int step = 0; clock.elapsed() < 4000; ++step) {
    sim::HandSetpoint setpoint;
    setpoint.p_WT = Vec3(0.03 * std::sin(0.05 * step), 0.0, 0.045);
    story.arm().setSetpoint(setpoint);
    QTest::qWait(5);
  }
  const double rate_hz =
      1e3 * static_cast<double>(story.view().framesDrawn() - before) / static_cast<double>(clock.elapsed());
  std::printf("%.0f pictures a second at 1280 x 800 (%s)\n", rate_hz, story.view().graphicsName().toUtf8().constData());
  EXPECT_GT(story.view().framesDrawn(), before + 2);  // the goal of 25 a second is the benchmark's: it has its machine
  EXPECT_EQ(story.snapshot().dropped, 0);
}

TEST(RealTimeStory, TheProgramDrawsItsFirstPictureByItselfAndStaysSmall) {
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("UNDERACT_TIMING", "1");
  program.setProcessEnvironment(environment);
  program.start(UNDERACT_WINDOW, {shippedScene("02_sphere")});
  QByteArray given;
  for (int waited = 0; waited < 600 && !given.contains("first picture"); ++waited) {
    program.waitForReadyRead(100);
    given += program.readAllStandardError();
  }
  const auto match = QRegularExpression("first picture after (\\d+) ms").match(given);
  EXPECT_TRUE(match.hasMatch()) << given.toStdString();
  QTest::qWait(3000);  // the plots have something to show
  const double resident = 1e-6 * underact::test::residentBytes(static_cast<long>(program.processId()));
  QFile maps(QString("/proc/%1/maps").arg(program.processId()));
  const bool is_mesa_25 = maps.open(QIODevice::ReadOnly) && maps.readAll().contains("libgallium-");
  // The first is a number for the reader; its goal of 0.4 s is the benchmark's, which has its machine.
  std::printf("first picture after %s ms, then %.0f MB resident\n", match.captured(1).toUtf8().constData(), resident);
#ifndef __SANITIZE_ADDRESS__  // which keeps what is freed, and a shadow of all
  EXPECT_LT(resident, kMaxWithOneScene_MB + (is_mesa_25 ? kMoreOfMesa25_MB : 0.0));
#endif
  EXPECT_GT(resident, 20.0);
  program.kill();
  program.waitForFinished();
}

}  // namespace underact::gui::test
