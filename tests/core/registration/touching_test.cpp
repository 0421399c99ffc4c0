#include "core/registration/touching.h"

#include <gtest/gtest.h>

#include "core/registration/sheet.h"

namespace underact::registration {
namespace {

using Event = Touching::Event;

/// A person at an arm that ticks every millisecond.
struct Person {
  explicit Person(std::size_t marks = 3) : touching(sheetPoints(marks)) {}
  /// The tip rests at p for so long, the button down or not; the last event that was one.
  Event rest(const Vec3& p_WT, int milliseconds, bool pressed, double speed_m_per_ms = 0.0) {
    Event last = Event::None;
    for (int at = 0; at < milliseconds; ++at) {
      const Vec3 there = p_WT + at * speed_m_per_ms * Vec3::UnitX();
      const Event event = touching.add(++time_ms * 1'000'000, there, pressed);
      if (event != Event::None) last = event;
    }
    return last;
  }
  Event touch(const Vec3& p_WT) {
    EXPECT_EQ(rest(p_WT, 100, false), Event::None);
    EXPECT_EQ(rest(p_WT, 50, true), Event::Began);
    return rest(p_WT, 600, false);
  }
  Touching touching;
  std::int64_t time_ms = 0;
};

const Vec3 kA(0.01, -0.06, 0.0), kB(0.05, -0.06, 0.0), kC(0.01, -0.06, -0.05);

TEST(Touching, MarkAfterMarkByTheButton) {
  Person person;
  for (const Vec3& p_WT : {kA, kB, kC}) {
    EXPECT_FALSE(person.touching.isDone());
    EXPECT_EQ(person.touch(p_WT), Event::Touched);
  }
  EXPECT_TRUE(person.touching.isDone());
  EXPECT_EQ(person.touching.due(), 3U);
  const std::vector<Touch> touches = person.touching.touches();
  ASSERT_EQ(touches.size(), 3U);
  EXPECT_LT((touches[1].p_WM - kB).norm(), 1e-15);
  EXPECT_EQ(touches[1].p_DM, sheetPoints()[1]);
  EXPECT_EQ(person.rest(kA, 1000, true), Event::None);  // no mark is due
}

TEST(Touching, AButtonThatWasDownAtFirstBeginsNothing) {
  Person person;
  EXPECT_EQ(person.rest(kA, 2000, true), Event::None);
  EXPECT_EQ(person.touch(kA), Event::Touched);
}

TEST(Touching, AButtonThatStaysDownTouchesOnce) {
  Person person;
  person.rest(kA, 10, false);
  EXPECT_EQ(person.rest(kA, 3000, true), Event::Touched);
  EXPECT_EQ(person.touching.due(), 1U);
}

TEST(Touching, ATipThatMovedIsNotTakenAndTheMarkStaysDue) {
  Person person;
  person.rest(kA, 10, false);
  EXPECT_EQ(person.rest(kA, 700, true, 1e-5), Event::Moved);
  EXPECT_EQ(person.touching.due(), 0U);
  EXPECT_TRUE(person.touching.touches().empty());
  EXPECT_EQ(person.touch(kA), Event::Touched);
}

TEST(Touching, OneMarkCanBeTouchedAgain) {
  Person person;
  person.touch(kA);
  person.touch(kC);
  person.touching.choose(1);
  EXPECT_EQ(person.touching.due(), 1U);
  EXPECT_EQ(person.touch(kB), Event::Touched);
  EXPECT_EQ(person.touching.due(), 2U);  // on to the first that was not touched
  EXPECT_LT((person.touching.held(1)->p_WT - kB).norm(), 1e-15);
  person.touch(kC);
  EXPECT_TRUE(person.touching.isDone());
  person.touching.choose(0);
  EXPECT_FALSE(person.touching.isDone());
  person.touching.choose(9);  // there is none
  EXPECT_EQ(person.touching.due(), 0U);
}

TEST(Touching, TheKeyDoesWhatTheButtonDoes) {
  Person person;
  person.rest(kA, 10, false);
  person.touching.press();
  EXPECT_TRUE(person.touching.isHolding());
  EXPECT_EQ(person.rest(kA, 300, false), Event::None);
  EXPECT_NEAR(person.touching.share(), 0.6, 0.01);
  person.touching.release();
  EXPECT_EQ(person.rest(kA, 600, false), Event::None);
  person.touching.press();
  EXPECT_EQ(person.rest(kA, 600, false), Event::Touched);
}

}  // namespace
}  // namespace underact::registration
