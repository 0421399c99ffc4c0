#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/arm/jacobian.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/lesson/check_text.h"
#include "core/lesson/read.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "device/lesson_attempt.h"
#include "device/simulated_arm.h"

namespace underact::test {

// The lessons that ship, and the hands that try them: NAME.json beside this file.

inline const std::string kLessons = std::string(UNDERACT_SOURCE) + "/resources/lessons/";
inline const std::string kScenes = std::string(UNDERACT_SOURCE) + "/scenes";
inline const std::string kTries = std::string(UNDERACT_TEST_DATA) + "/lessons/";

inline std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(kLessons)) {
    const std::filesystem::path stem = entry.path().stem();
    if (entry.path().extension() == ".json" && stem.extension() != ".schema") all.push_back(stem.string());
  }
  std::sort(all.begin(), all.end());
  return all;
}

inline lesson::Lesson lessonOf(const std::string& name) {
  Result<lesson::Lesson> read = lesson::readLessonFile(kLessons + name + ".json");
  EXPECT_TRUE(read) << name;
  return read ? std::move(read).value() : lesson::Lesson{};
}

inline json::Value fileOf(const std::string& path) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const Result<json::Value> value = json::parse(text, path);
  EXPECT_TRUE(value) << path << " " << (value ? "" : describe(value.problems().front()));
  return value ? value.value() : json::Value{};
}

/// "joints": [t, six angles in degrees], "path": [t, x, y, z in mm], or "about_z": [t, x, y, z, degrees about z].
inline sim::HandScript handOf(const json::Value& attempt) {
  sim::HandScript hand;
  const json::Value *const joints = attempt.find("joints"), *const about_z = attempt.find("about_z");
  for (const json::Value& row : (joints != nullptr    ? joints
                                 : about_z != nullptr ? about_z
                                                      : attempt.find("path"))
                                    ->items) {
    sim::HandPoint point{row.items.at(0).number};
    if (joints != nullptr) {
      arm::JointAngles q_rad{};
      for (std::size_t joint = 0; joint < 6; ++joint) q_rad[joint] = kRadPerDegree * row.items.at(joint + 1).number;
      const Pose X_WT = arm::kinematics(arm::findPreset(arm::kDefaultArm)->geometry, q_rad).X_WT;
      point.p_WT = X_WT.translation(), point.R_WT = X_WT.linear(), point.turns = true;
    } else {
      point.p_WT = 1e-3 * Vec3(row.items.at(1).number, row.items.at(2).number, row.items.at(3).number);
      if (about_z != nullptr) {
        point.R_WT = Eigen::AngleAxisd(kRadPerDegree * row.items.at(4).number, Vec3::UnitZ()).toRotationMatrix();
        point.turns = true;
      }
    }
    hand.path.push_back(point);
  }
  return hand;
}

inline device::LessonAttempt attemptOf(const json::Value& value) {
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

inline scene::Description sceneOf(const lesson::Lesson& lesson, std::size_t step) {
  Result<scene::Description> scene = scene::readSceneFile(lesson::sceneFileOf(lesson, step, kScenes));
  EXPECT_TRUE(scene);
  EXPECT_TRUE(scene::loadMeshes(scene.value()).empty());
  return std::move(scene).value();
}

inline device::LessonOutcome outcomeOf(const lesson::Lesson& lesson, std::size_t step,
                                       const device::LessonAttempt& attempt) {
  const Result<device::LessonOutcome> outcome =
      device::tryLessonStep(lesson.steps[step], sceneOf(lesson, step), attempt);
  EXPECT_TRUE(outcome) << lesson.title << " " << step + 1 << ": " << describe(outcome.problems().front());
  return outcome ? outcome.value() : device::LessonOutcome{};
}

inline std::string told(const lesson::Step& step, const device::LessonOutcome& outcome) {
  std::string all = outcome.fault.kind == FaultKind::None ? "" : describe(outcome.fault) + "\n";
  for (std::size_t index = 0; index < outcome.states.size(); ++index)
    all += describeCheck(step.checks[index], outcome.states[index]) + "\n";
  return all;
}

}  // namespace underact::test
