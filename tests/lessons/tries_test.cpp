#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/page/page.h"
#include "core/arm/jacobian.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/lesson/check_text.h"
#include "core/lesson/read.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "device/lesson_attempt.h"

namespace underact::test {
namespace {

namespace fs = std::filesystem;
const std::string kLessons = std::string(UNDERACT_SOURCE) + "/resources/lessons/";
const std::string kScenes = std::string(UNDERACT_SOURCE) + "/scenes";
const std::string kTries = std::string(UNDERACT_TEST_DATA) + "/lessons/";

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(kLessons)) {
    const fs::path stem = entry.path().stem();
    if (entry.path().extension() == ".json" && stem.extension() != ".schema") all.push_back(stem.string());
  }
  std::sort(all.begin(), all.end());
  return all;
}

json::Value fileOf(const std::string& path) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const Result<json::Value> value = json::parse(text, path);
  EXPECT_TRUE(value) << path << " " << (value ? "" : describe(value.problems().front()));
  return value ? value.value() : json::Value{};
}

/// "joints": [t, six angles in degrees], "path": [t, x, y, z in mm].
sim::HandScript handOf(const json::Value& attempt) {
  sim::HandScript hand;
  const json::Value* const joints = attempt.find("joints");
  for (const json::Value& row : (joints != nullptr ? joints : attempt.find("path"))->items) {
    sim::HandPoint point{row.items.at(0).number};
    if (joints != nullptr) {
      arm::JointAngles q_rad{};
      for (std::size_t joint = 0; joint < 6; ++joint) q_rad[joint] = kRadPerDegree * row.items.at(joint + 1).number;
      const Pose X_WT = arm::kinematics(arm::findPreset(arm::kDefaultArm)->geometry, q_rad).X_WT;
      point.p_WT = X_WT.translation(), point.R_WT = X_WT.linear(), point.turns = true;
    } else {
      point.p_WT = 1e-3 * Vec3(row.items.at(1).number, row.items.at(2).number, row.items.at(3).number);
    }
    hand.path.push_back(point);
  }
  return hand;
}

device::LessonAttempt attemptOf(const json::Value& value) {
  device::LessonAttempt attempt;
  attempt.hand = handOf(value);
  attempt.starts = value.find("stopped") == nullptr;
  if (const json::Value* const set = value.find("set")) {
    for (std::size_t index = 0; index < set->keys.size(); ++index)
      attempt.settings.push_back({set->keys[index], set->items[index].text});
  }
  if (const json::Value* const answers = value.find("answers")) {
    for (const json::Value& answer : answers->items) attempt.answers.push_back(answer.number);
  }
  return attempt;
}

scene::Description sceneOf(const lesson::Lesson& lesson, std::size_t step) {
  Result<scene::Description> scene = scene::readSceneFile(lesson::sceneFileOf(lesson, step, kScenes));
  EXPECT_TRUE(scene);
  EXPECT_TRUE(scene::loadMeshes(scene.value()).empty());
  return std::move(scene).value();
}

device::LessonOutcome outcomeOf(const lesson::Lesson& lesson, std::size_t step, const device::LessonAttempt& attempt) {
  const Result<device::LessonOutcome> outcome =
      device::tryLessonStep(lesson.steps[step], sceneOf(lesson, step), attempt);
  EXPECT_TRUE(outcome) << lesson.title << " " << step + 1 << ": " << describe(outcome.problems().front());
  return outcome ? outcome.value() : device::LessonOutcome{};
}

std::string told(const lesson::Step& step, const device::LessonOutcome& outcome) {
  std::string all = outcome.fault.kind == FaultKind::None ? "" : describe(outcome.fault) + "\n";
  for (std::size_t index = 0; index < outcome.states.size(); ++index)
    all += describeCheck(step.checks[index], outcome.states[index]) + "\n";
  return all;
}

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
  still.hand.path = {{0.0, Vec3(0, 0, 0.05)}, {3.0, Vec3(0, 0, 0.05)}};  // where the arm of the window begins
  for (std::size_t step = 0; step < lesson_.steps.size(); ++step) {
    const device::LessonOutcome outcome = outcomeOf(lesson_, step, still);
    EXPECT_FALSE(outcome.isSolved()) << "step " << step + 1 << "\n" << told(lesson_.steps[step], outcome);
  }
}

TEST_P(Lessons, EveryFormulaCanBeShown) {
  for (const lesson::Step& step : lesson_.steps) {
    for (const std::string& text : {step.text, step.hint}) {
      const page::Page page = page::readPage(text, GetParam());
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
