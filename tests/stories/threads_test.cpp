#include <gtest/gtest.h>

#include <QFile>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <atomic>
#include <cmath>
#include <functional>

#include "app/gui/fault/fault_dialog.h"
#include "app/gui/model/player.h"
#include "tests/stories/mesh_desk.h"
#include "tests/stories/story.h"
#include "tests/support/loose_cable.h"

// Where the window meets other threads: the servo ticks by itself while it is edited, recorded, exchanged and lost, and
// files are read and written beside it. ThreadSanitizer runs these (packaging/test), so nothing here looks at how long
// a thing takes.
namespace underact::gui::test {
namespace {

using underact::test::LooseCable;

// Ticks come late on a machine that is busy, and under a sanitizer. Nothing is asked of the system: locking the memory
// would lock the sanitizer's, too.
servo::HostOptions byItself() {
  return {.clock = servo::Clock::Thread,
          .scheduling = {.method = system::SchedulingMethod::Normal, .core = -1, .lock_memory = false},
          .watchdog_s = 30.0,
          .max_late = 1'000'000};
}

bool comes(const std::function<bool()>& it) {
  return QTest::qWaitFor(it, 3 * kLong_ms);
}

bool comeTicks(Story& story, std::int64_t count) {
  const std::int64_t until = story.snapshot().ticks + count;
  return comes([&story, until] { return story.snapshot().ticks >= until; });
}

// Nobody is there to answer what becomes of the edits.
bool opens(Story& story, const QString& name) {
  story.window().document().undoStack().setClean();
  return story.perform("scene.open", shippedScene(name));
}

void stir(Story& story, int step) {
  sim::HandSetpoint setpoint;
  setpoint.p_WT = Vec3(0.02 * std::sin(0.3 * step), 0.0, 0.045);
  story.arm().setSetpoint(setpoint);
}

}  // namespace

TEST(ThreadsStory, AServoThatTicksByItselfIsPushedEditedAndGivenOtherScenes) {
  Story story("02_sphere", {.servo = byItself()});
  story.perform("dock.servo", true);
  story.perform("session.start");
  for (int step = 0; step < 40; ++step) {
    stir(story, step);
    if (step % 4 == 0) {
      EXPECT_TRUE(story.perform("gains.set", "kp", "x", 0.2 + 0.01 * step));
    }
    if (step % 8 == 7) {
      EXPECT_TRUE(opens(story, step % 16 == 7 ? "06_cylinder" : "02_sphere"));
    }
    if (step == 20) {
      EXPECT_TRUE(story.perform("servo.rate", 500));
    }
    QTest::qWait(20);
  }
  ASSERT_TRUE(opens(story, "27_bracket"));  // its mesh is read in the background
  ASSERT_TRUE(waitForMeshes(story));
  ASSERT_TRUE(comes([&story] { return story.snapshot().revision == story.host().revision(); }));
  EXPECT_TRUE(comeTicks(story, 100));
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  EXPECT_EQ(story.snapshot().report.fault.kind, FaultKind::None);
  EXPECT_GT(story.view().framesDrawn(), 2);
}

TEST(ThreadsStory, WhatItDoesIsRecordedListedExportedAndReplayed) {
  const QTemporaryDir folder;
  forgetSettings();
  QSettings().setValue("hints/has_pushed", true);
  QSettings().setValue("recording/folder", folder.path());
  Story story("02_sphere", {.first_start = false, .servo = byItself()});
  story.window().resize(1280, 800);
  story.perform("dock.sessions", true);
  story.perform("session.start");
  ASSERT_TRUE(story.perform("session.record", true));
  for (int step = 0; step < 20; ++step) {
    stir(story, step);
    if (step == 8) {
      EXPECT_TRUE(story.perform("session.mark", "here"));
    }
    if (step == 12) {
      EXPECT_TRUE(story.perform("gains.set", "kp", "x", 0.3));
    }
    QTest::qWait(20);
  }
  ASSERT_TRUE(comeTicks(story, 500));
  ASSERT_TRUE(story.perform("session.record", false));
  auto* list = story.find<QListWidget>("panel.sessions.list");
  ASSERT_TRUE(comes([list] { return list->count() == 1; }));
  const QString session = list->item(0)->data(Qt::UserRole).toString();
  ASSERT_TRUE(comes([&] { return story.perform("sessions.choose", session); }));
  ASSERT_TRUE(story.perform("sessions.export", folder.filePath("out.csv")));
  ASSERT_TRUE(comes([&folder] { return QFile::exists(folder.filePath("out.csv")); }));
  story.window().document().undoStack().setClean();
  ASSERT_TRUE(story.perform("replay.open", session));
  Player& player = story.window().player();
  ASSERT_TRUE(comes([&player] { return player.isOpen() && !player.isLoading(); }));
  EXPECT_TRUE(comes([&player] { return player.row() > 200; })) << "it plays when it is opened";
  EXPECT_TRUE(story.perform("replay.seek", 0.1));
  EXPECT_TRUE(comeTicks(story, 100));
  EXPECT_TRUE(story.perform("replay.close"));
  EXPECT_TRUE(comeTicks(story, 100));
  EXPECT_FALSE(player.isOpen());
}

TEST(ThreadsStory, APulledCableIsToldAndTheServoBegunAnew) {
  forgetSettings();
  std::atomic<bool> plugged_in{true};
  servo::Host host(std::make_unique<LooseCable>(simulatedArmOptions(1000), plugged_in), byItself());
  host.begin();
  ThemeWatcher theme;
  MainWindow window({host, nullptr, theme});
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  ASSERT_TRUE(window.actions().perform("scene.open", shippedScene("02_sphere")));
  window.actions().perform("session.start");
  ASSERT_TRUE(comes([&host] { return host.snapshot().mode == servo::Mode::Running; }));
  plugged_in = false;
  const auto dialog = [&window] { return window.findChild<FaultDialog*>("dialog.fault"); };
  ASSERT_TRUE(comes([&dialog] { return dialog() != nullptr && dialog()->isVisible(); }));
  EXPECT_EQ(host.snapshot().mode, servo::Mode::Faulted);
  plugged_in = true;
  QTest::mouseClick(window.findChild<QPushButton*>("dialog.fault.restart"), Qt::LeftButton);
  ASSERT_TRUE(comes([&dialog] { return !dialog()->isVisible(); }));
  window.actions().perform("session.start");
  EXPECT_TRUE(comes([&host] { return host.snapshot().mode == servo::Mode::Running; }));
  window.close();
}

}  // namespace underact::gui::test
