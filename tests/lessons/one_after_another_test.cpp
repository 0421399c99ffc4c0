// Each lesson from where each other lesson ends: what a step begins with is its own, not the last lesson's.
#include <gtest/gtest.h>

#include "core/lesson/stage.h"
#include "tests/lessons/tries.h"

namespace underact::test {
namespace {

constexpr double kLooks_s = 3.0;

/// Ends a lesson: its last step, done by the hand that solves it, with the servo left as that hand has it.
void end(device::LessonDesk& desk, const lesson::Lesson& lesson, const json::Value& tries) {
  const std::size_t last = lesson.steps.size() - 1;
  const auto outcome = desk.tryStep(lesson.steps[last], sceneOf(lesson, last),
                                    attemptOf(*tries.find("tries")->items[last].find("right")));
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome.value().isSolved()) << lesson.title << "\n" << told(lesson.steps[last], outcome.value());
}

class FromEachOther : public testing::TestWithParam<std::string> {};

TEST_P(FromEachOther, NoStepIsSolvedOnArrivalAndEachCanBeSolved) {
  const std::string before = GetParam();
  const lesson::Lesson first = lessonOf(before);
  const json::Value first_tries = fileOf(kTries + before + ".json");
  for (const std::string& name : names()) {
    if (name == before) continue;
    const lesson::Lesson next = lessonOf(name);
    const json::Value tries = fileOf(kTries + name + ".json");
    for (std::size_t step = 0; step < next.steps.size(); ++step) {
      device::LessonDesk desk;
      end(desk, first, first_tries);
      device::LessonAttempt still;
      still.seconds = kLooks_s;
      const auto arrived = desk.tryStep(next.steps[step], sceneOf(next, step), still);
      ASSERT_TRUE(arrived);
      EXPECT_FALSE(arrived.value().isSolved())
          << before << " then " << name << " step " << step + 1 << " is solved on arrival";
      const auto done = desk.tryStep(next.steps[step], sceneOf(next, step),
                                     attemptOf(*tries.find("tries")->items[step].find("right")));
      ASSERT_TRUE(done);
      EXPECT_TRUE(done.value().isSolved()) << before << " then " << name << " step " << step + 1 << "\n"
                                           << told(next.steps[step], done.value());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, FromEachOther, testing::ValuesIn(names()),
                         [](const testing::TestParamInfo<std::string>& one) { return one.param; });

TEST(LessonStage, TheArmBeginsInThePoseOfTheStepWhateverWasBefore) {
  lesson::Lesson lesson = lessonOf("02_dh");
  device::LessonDesk desk;
  end(desk, lessonOf("04_inverse"), fileOf(kTries + "04_inverse.json"));
  device::LessonAttempt still;
  still.seconds = 0.5;
  lesson.steps[3].pose_deg = {0, 45, 15, 0, 90, -90};  // the answer: now it is solved on arrival, but for the time
  const auto outcome = desk.tryStep(lesson.steps[3], sceneOf(lesson, 3), still);
  ASSERT_TRUE(outcome);
  EXPECT_NEAR(outcome.value().states[0].now[1], 45.0, 0.1);
  EXPECT_NEAR(outcome.value().states[0].now[2], 15.0, 0.1);
}

TEST(LessonStage, TargetsAreWhereTheChecksWantTheTip) {
  const lesson::Lesson frames = lessonOf("01_frames"), dh = lessonOf("02_dh");
  const arm::Preset& omni = *arm::findPreset(arm::kDefaultArm);
  const std::vector<lesson::TargetPlace> visited = targetsOf(frames.steps[0], omni);
  ASSERT_EQ(visited.size(), 3U);
  EXPECT_TRUE(visited[1].p_WT.isApprox(Vec3(0.0, 0.04, 0.05)));
  EXPECT_DOUBLE_EQ(visited[1].within_m, 0.006);
  std::vector<lesson::CheckState> states(1);
  states[0].visited = {false, true, false};
  EXPECT_FALSE(isReached(visited[0], states));
  EXPECT_TRUE(isReached(visited[1], states));
  ASSERT_EQ(targetsOf(frames.steps[2], omni).size(), 1U);  // (216, 0, 10) mm in B
  EXPECT_TRUE(targetsOf(frames.steps[2], omni)[0].p_WT.isApprox(Vec3(0.0, 0.04, 0.04), 1e-9));
  ASSERT_EQ(targetsOf(dh.steps[3], omni).size(), 1U);  // joints 0, 45, 15: by the thesis's eq. 3.5
  const double r_mm = 127.508 * std::cos(kRadPerDegree * 45) + 149.352 * std::sin(kRadPerDegree * 60);
  EXPECT_NEAR(targetsOf(dh.steps[3], omni)[0].p_WT.z(), 1e-3 * (r_mm - 176.0), 1e-3);
  EXPECT_TRUE(targetsOf(dh.steps[0], omni).empty());
}

TEST(LessonStage, WhatAnOpenQuestionAsksForIsKnown) {
  const lesson::Lesson inverse = lessonOf("04_inverse");
  std::vector<lesson::CheckState> states(1);
  EXPECT_TRUE(asksFor(inverse.steps[0], states, "solutions"));
  EXPECT_FALSE(asksFor(inverse.steps[0], states, "solutions_within"));
  states[0].solved = true;
  EXPECT_FALSE(asksFor(inverse.steps[0], states, "solutions"));
}

TEST(LessonStage, EveryLessonSaysHowLongItTakes) {
  for (const std::string& name : names()) EXPECT_GT(lessonOf(name).minutes, 0.0) << name;
  lesson::Lesson unsaid;
  unsaid.steps.resize(3);
  EXPECT_DOUBLE_EQ(minutesOf(unsaid), 6.0);
}

}  // namespace
}  // namespace underact::test
