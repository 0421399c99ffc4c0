#pragma once
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>

#include "app/gui/visitor/visitor_mode.h"
#include "tests/stories/story.h"
#include "tests/support/loose_cable.h"

namespace underact::gui::test {

/// The window on a simulated arm whose cable can be pulled, with nothing remembered, and visitors at it.
struct VisitorDesk {
  explicit VisitorDesk(const QStringList& scenes = {"02_sphere", "07_box_outside", "05_circle"}) {
    forgetSettings();
    auto port = std::make_unique<underact::test::LooseCable>(simulatedArmOptions(1000), plugged_in);
    cable = port.get();
    host = std::make_unique<servo::Host>(std::move(port), servo::HostOptions{.clock = servo::Clock::Manual});
    window = std::make_unique<MainWindow>(WindowParts{*host, &cable->arm(), theme});
    window->resize(1280, 800);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
    window->actions().perform("scene.open", QVariant(shippedScene("09_wall")));
    window->actions().perform("session.start");
    run(500);
    for (const QString& name : scenes) paths << shippedScene(name);
  }
  ~VisitorDesk() {
    window->findChild<VisitorMode*>()->leave();
    window->document().undoStack().setClean();
    window->close();
  }
  bool begin() {
    const bool started = window->actions().perform("visitor.start", QVariant(paths));
    return started && QTest::qWaitFor([this] {
             run(1);
             return window->findChild<VisitorMode*>()->count() == static_cast<std::size_t>(paths.size());
           });
  }
  /// Ticks, with a frame each tenth of a second.
  void run(std::int64_t ticks) {
    for (std::int64_t done = 0; done < ticks; done += 100) {
      host->run(std::min<std::int64_t>(100, ticks - done));
      window->frame();
    }
  }
  void setpointAt(const Vec3& p_W) { cable->arm().setSetpoint({.p_WT = p_W}); }
  /// A hand that presses as deep into the ball as it can.
  double maxPushed_N() {
    static_cast<void>(cable->takeMax_N());
    setpointAt({0.0, 0.0, 0.030});
    run(1500);
    return cable->takeMax_N();
  }
  template <class Widget = QWidget>
  Widget* find(const char* name) {
    auto* found = window->findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  QString label(const char* name) { return find<QLabel>(name)->text(); }
  void press(const char* button) {
    auto* found = find<QPushButton>(button);
    ASSERT_TRUE(found->isVisible()) << button;
    found->click();
  }
  std::string scene() const { return host->scene().title; }

  std::atomic<bool> plugged_in{true};
  underact::test::LooseCable* cable;
  ThemeWatcher theme;
  std::unique_ptr<servo::Host> host;
  std::unique_ptr<MainWindow> window;
  QStringList paths;
};

}  // namespace underact::gui::test
