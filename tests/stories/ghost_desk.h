#pragma once
#include <QLabel>
#include <functional>

#include "app/gui/ghost/ghost_hand.h"
#include "tests/stories/story.h"

namespace underact::gui::test {

inline constexpr int kTeacherTicks = 3000, kTeacherStep = 25;         // of the teacher's hand; between two wishes
inline constexpr int kTeacherAll = kTeacherTicks + 2 * kTeacherStep;  // in which the ghost has come to its end

/// The teacher's hand: 30 mm to the right and back, in a loop, in 3 s.
Vec3 teacherAt(int tick);
void moveHand(device::SimulatedArm& arm, const Vec3& p_W);
/// A session of 3 s beside the sphere.
QString teacherSession();
/// Waits for what is read in another thread; no tick comes meanwhile.
bool waitFor(const std::function<bool()>& what);

/// A window with the teacher's ghost in it.
struct Class : Story {
  explicit Class(const QString& scene = "02_sphere", const QString& path = teacherSession()) : Story(scene) {
    moveHand(arm(), teacherAt(0));
    run(500);
    EXPECT_TRUE(perform("ghost.open", path));
    EXPECT_TRUE(waitFor([this] { return ghost().isOpen(); }));
  }
  GhostHand& ghost() { return *window().findChild<GhostHand*>(); }
  const ghost::State& state() { return ghost().state(); }
  /// The student's hand does what the teacher's did from one tick to another, so many ticks later.
  void follow(int from, int to, int lag = 0) {
    for (int tick = from; tick < to; tick += kTeacherStep) {
      moveHand(arm(), teacherAt(tick - lag));
      run(kTeacherStep);
    }
  }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
};

}  // namespace underact::gui::test
