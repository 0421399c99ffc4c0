#include "tests/stories/identify_desk.h"

#include <gtest/gtest.h>

#include <utility>

namespace underact::gui::test {
namespace {

constexpr int kCableTicksAFrame = 16, kTicksAtOnce = 250;

class CableArm final : public servo::DevicePort {
 public:
  explicit CableArm(std::atomic<bool>& plugged_in) : arm_(simulatedArmOptions(1000)), plugged_in_(plugged_in) {
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

Wizard::Wizard(MainWindow& window, std::function<void(int ticks)> tick) : window_(window), tick_(std::move(tick)) {
  EXPECT_TRUE(window_.actions().perform("identify.open"));
  EXPECT_TRUE(QTest::qWaitForWindowExposed(dialog()));
}

QWidget* Wizard::widget(const QString& name) {
  auto* const found = dialog()->findChild<QWidget*>(name);
  EXPECT_NE(found, nullptr) << name.toStdString();
  return found;
}

void Wizard::press(const QString& name) {
  ASSERT_TRUE(in(name)->isVisible() && in(name)->isEnabled()) << name.toStdString();
  in(name)->click();
}

void Wizard::begin() {
  press("identify.next");
  press("identify.next");
}

bool Wizard::record() {
  for (int ticks = 0; ticks < kMaxTicks; ticks += kTicksAtOnce) {
    if (state() == State::Asks && in("identify.go")->isVisible()) press("identify.go");
    if (state() != State::Asks && state() != State::Runs) break;
    tick_(kTicksAtOnce);
  }
  return state() == State::Evaluates || state() == State::Done;
}

void Wizard::measure() {
  begin();
  ASSERT_TRUE(record()) << run().why().toStdString();
  ASSERT_TRUE(comes([this] { return state() == State::Done; })) << run().why().toStdString();
}

void Wizard::keepPicture(const QString& name) {
  QTest::qWait(150);
  EXPECT_TRUE(dialog()->grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/" + name + ".png"));
}

IdentifyDesk::IdentifyDesk(const Beginning& beginning, bool servo_runs)
    : Story("02_sphere", beginning), wizard(window(), [this](int ticks) { run(ticks); }) {
  if (servo_runs) perform("session.start");
  run(500);
  settle();
}

IdentifyOnCable::IdentifyOnCable()
    : host(std::make_unique<CableArm>(plugged_in), {.clock = servo::Clock::Manual}),
      window((forgetSettings(), WindowParts{host, nullptr, theme})) {
  window.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
  EXPECT_TRUE(window.actions().perform("scene.open", {shippedScene("02_sphere")}));
  wizard = std::make_unique<Wizard>(window, [this](int ticks) { run(ticks); });
}

IdentifyOnCable::~IdentifyOnCable() {
  window.document().undoStack().setClean();  // nobody is there to answer what becomes of the edits
  window.close();
}

void IdentifyOnCable::run(int ticks) {
  for (int done = 0; done < ticks; done += kCableTicksAFrame) {
    host.run(std::min(kCableTicksAFrame, ticks - done));
    window.frame();
  }
}

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

}  // namespace underact::gui::test
