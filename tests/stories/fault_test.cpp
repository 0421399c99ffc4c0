#include <gtest/gtest.h>

#include <QLabel>
#include <atomic>

#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

// A simulated arm whose cable can be pulled.
class LooseCable final : public servo::DevicePort {
 public:
  LooseCable(const device::SimulatedArm::Options& options, std::atomic<bool>& plugged_in)
      : arm_(options), plugged_in_(plugged_in) {}
  bool read(arm::Sample& sample) noexcept override { return arm_.read(sample) && plugged_in_.load(); }
  void write(const safety::GatedForce& force) noexcept override { arm_.write(force); }
  void cut() noexcept override { arm_.cut(); }
  servo::DeviceInfo info() const override { return {"Arm on a loose cable", false, true}; }

 private:
  device::SimulatedArm arm_;
  std::atomic<bool>& plugged_in_;
};

}  // namespace

TEST(FaultStory, APulledCableIsSaidAndStartClearsIt) {
  forgetSettings();
  std::atomic<bool> plugged_in{true};
  servo::Host host(std::make_unique<LooseCable>(simulatedArmOptions(1000), plugged_in),
                   {.clock = servo::Clock::Manual});
  ThemeWatcher theme;
  MainWindow window({host, nullptr, theme});
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  window.actions().perform("scene.open", shippedScene("02_sphere"));
  window.actions().perform("session.start");
  host.run(500);
  window.frame();
  const auto label = [&window](const char* name) { return window.findChild<QLabel*>(name); };
  EXPECT_EQ(label("status.mode")->text(), "Running");
  EXPECT_EQ(label("status.device")->text(), "Arm on a loose cable (untested)");
  plugged_in = false;
  host.run(100);
  window.frame();
  EXPECT_EQ(host.snapshot().mode, servo::Mode::Faulted);
  EXPECT_EQ(host.snapshot().report.force.f_T_W().norm(), 0.0);
  EXPECT_EQ(label("status.mode")->text(), "Fault");
  EXPECT_TRUE(label("status.mode")->toolTip().contains("stopped answering"));
  plugged_in = true;
  ASSERT_TRUE(window.actions().find("session.start")->isEnabled());
  window.actions().perform("session.start");
  host.run(100);
  window.frame();
  EXPECT_EQ(label("status.mode")->text(), "Running");
}

}  // namespace underact::gui::test
