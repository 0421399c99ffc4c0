#include "tests/lessons/tries.h"

#include <gtest/gtest.h>

#include "app/page/page.h"

namespace underact::test {
namespace {

class Lessons : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    Result<lesson::Lesson> read = lesson::readLessonFile(kLessons + GetParam() + ".json");
    ASSERT_TRUE(read) << describe(read.problems().front());
    lesson_ = std::move(read).value();
    tries_ = fileOf(kTries + GetParam() + ".json");
    ASSERT_EQ(tries_.find("tries")->items.size(), lesson_.steps.size());
  }
  const json::Value& tryOf(std::size_t step, const char* kind) { return *tries_.find("tries")->items[step].find(kind); }

  lesson::Lesson lesson_;
  json::Value tries_;
};

TEST_P(Lessons, EachStepIsSolvedByTheRightHand) {
  for (std::size_t step = 0; step < lesson_.steps.size(); ++step) {
    const device::LessonOutcome outcome = outcomeOf(lesson_, step, attemptOf(tryOf(step, "right")));
    EXPECT_TRUE(outcome.isSolved()) << "step " << step + 1 << "\n" << told(lesson_.steps[step], outcome);
  }
}

TEST_P(Lessons, EachStepTellsTheWrongHandWhatIsMissing) {
  for (std::size_t step = 0; step < lesson_.steps.size(); ++step) {
    const device::LessonOutcome outcome = outcomeOf(lesson_, step, attemptOf(tryOf(step, "wrong")));
    EXPECT_FALSE(outcome.isSolved()) << "step " << step + 1 << "\n" << told(lesson_.steps[step], outcome);
    EXPECT_EQ(outcome.fault.kind, FaultKind::None) << "step " << step + 1;
    EXPECT_GT(told(lesson_.steps[step], outcome).size(), 10u);
  }
}

TEST_P(Lessons, NothingIsSolvedByDoingNothing) {
  device::LessonAttempt still;
  still.hand.path = {{0.0, device::kFirst_p_WT}, {3.0, device::kFirst_p_WT}};
  for (std::size_t step = 0; step < lesson_.steps.size(); ++step) {
    const device::LessonOutcome outcome = outcomeOf(lesson_, step, still);
    EXPECT_FALSE(outcome.isSolved()) << "step " << step + 1 << "\n" << told(lesson_.steps[step], outcome);
  }
}

TEST_P(Lessons, EveryFormulaCanBeShown) {
  for (const lesson::Step& step : lesson_.steps) {
    for (const std::string& text : {step.text, step.hint}) {
      const page::Page page = page::readPage(text, GetParam(), {}, page::kStrangersPage);
      for (const Problem& problem : page.problems) ADD_FAILURE() << step.title << ": " << describe(problem);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Lessons, testing::ValuesIn(names()),
                         [](const testing::TestParamInfo<std::string>& one) { return one.param; });

TEST(LessonTrial, TheSameHandGivesTheSameNumbers) {
  const lesson::Lesson lesson = lesson::readLessonFile(kLessons + "07_stiffness.json").value();
  const device::LessonAttempt attempt =
      attemptOf(*fileOf(kTries + "07_stiffness.json").find("tries")->items[0].find("right"));
  const device::LessonOutcome once = outcomeOf(lesson, 0, attempt), again = outcomeOf(lesson, 0, attempt);
  EXPECT_EQ(once.states[0].now[0], again.states[0].now[0]);
  EXPECT_EQ(once.states[0].last_ns, again.states[0].last_ns);
}

TEST(LessonTrial, SettingsThatAreNoneAreRefused) {
  const lesson::Lesson lesson = lesson::readLessonFile(kLessons + "07_stiffness.json").value();
  const auto refused = [&](const std::string& key, const std::string& value) {
    const Result<scene::Description> set = device::withSetting(sceneOf(lesson, 0), {key, value});
    return set ? Sentence() : set.problems().front().sentence;
  };
  EXPECT_EQ(refused("kp_N_per_mm", "0.1"), "");
  EXPECT_EQ(refused("law", "PID"), "");
  EXPECT_NE(refused("kp", "0.1").find("is none"), std::string::npos);
  EXPECT_NE(refused("kp_N_per_mm", "much").find("is not possible"), std::string::npos);
  EXPECT_NE(refused("kp_N_per_mm", "-1").find("is not possible"), std::string::npos);
  EXPECT_NE(refused("t", "0.5").find("is not possible"), std::string::npos);  // a point has no influence
  EXPECT_NE(refused("law", "bang").find("is not possible"), std::string::npos);
}

TEST(LessonTrial, MoreAnswersThanQuestionsAreAProblem) {
  const lesson::Lesson lesson = lesson::readLessonFile(kLessons + "07_stiffness.json").value();
  device::LessonAttempt attempt;
  attempt.hand.path = {{0.0, Vec3(0, 0, 0.06)}};
  attempt.answers = {1.0};
  EXPECT_FALSE(device::tryLessonStep(lesson.steps[0], sceneOf(lesson, 0), attempt));
}

}  // namespace
}  // namespace underact::test
