#include "tests/stories/ghost_desk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/record/recorder.h"
#include "core/scene/read.h"

namespace underact::gui::test {

Vec3 teacherAt(int tick) {
  const double angle_rad = 3.14159265 * std::clamp(tick, 0, kTeacherTicks) / kTeacherTicks;
  return {0.030 * std::sin(angle_rad), 0.015 * std::sin(2.0 * angle_rad), 0.06};
}

void moveHand(device::SimulatedArm& arm, const Vec3& p_W) {
  sim::HandSetpoint setpoint = arm.setpoint();
  setpoint.p_WT = p_W;
  arm.setSetpoint(setpoint);
}

QString teacherSession() {
  static const QString kPath = [] {
    const QString path = temporaryFile("teacher.h5");
    SimulatedHost simulated = makeSimulatedHost({.clock = servo::Clock::Manual});
    Document document(*simulated.host);
    EXPECT_TRUE(document.open(scene::readSceneFile(shippedScene("02_sphere").toStdString()).value()).empty());
    moveHand(*simulated.arm, teacherAt(0));
    simulated.host->run(500);
    auto recorder = record::Recorder::start(*simulated.host, path.toStdString(), {.name = "Round the ball"});
    EXPECT_TRUE(static_cast<bool>(recorder));
    for (int tick = 0; tick < kTeacherTicks; tick += kTeacherStep) {
      moveHand(*simulated.arm, teacherAt(tick));
      simulated.host->run(kTeacherStep);
    }
    EXPECT_TRUE(recorder.value()->stop().empty());
    return path;
  }();
  return kPath;
}

bool waitFor(const std::function<bool()>& what) {
  return QTest::qWaitFor(what, kLong_ms);
}

}  // namespace underact::gui::test
