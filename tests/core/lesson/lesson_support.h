#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/arm/forward.h"
#include "core/arm/preset.h"
#include "core/lesson/check.h"
#include "core/lesson/check_text.h"
#include "core/lesson/read.h"

namespace underact::lesson::test {

/// A tick of an arm that stands with these joints, with what a test puts into it.
struct Moment {
  explicit Moment(const arm::JointAngles& q_rad = {0.1, 0.6, 0.3, 0.2, 1.2, 0.3}) {
    tick.q_rad = q_rad;
    tick.p_WT = arm::tipPosition(preset.geometry, q_rad);
    tick.p_WP = tick.p_WT;
    scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 50.0}, {}, {}});
  }
  Observation seen() const { return {tick, scene, preset, robot}; }
  Moment& at(double time_s) {
    tick.time_ns = static_cast<std::int64_t>(1e9 * time_s);
    return *this;
  }

  const arm::Preset& preset = *arm::findPreset(arm::kDefaultArm);
  scene::Description scene;
  servo::TickRecord tick;
  target::Robot robot;
};

/// A lesson of one step with these checks, as JSON.
inline std::string lessonWith(const std::string& checks) {
  return R"({"underact_lesson": 1, "title": "T", "steps": [{"title": "S", "text": "x", "scene": "01_point", "checks": [)" +
         checks + "]}]}";
}

inline Check checkOf(const std::string& json) {
  const Result<Lesson> read = readLesson(lessonWith(json), "lesson.json");
  if (read) return read.value().steps.at(0).checks.at(0);
  ADD_FAILURE() << json << "\n" << describe(read.problems().front());
  return {};
}

inline std::vector<std::string> problemsIn(const std::string& text) {
  const Result<Lesson> read = readLesson(text, "lesson.json");
  std::vector<std::string> lines;
  if (!read) {
    for (const Problem& problem : read.problems()) lines.push_back(describe(problem));
  }
  return lines;
}

inline std::string sentenceOf(const Check& check, const CheckState& state) {
  return describeCheck(check, state);
}

}  // namespace underact::lesson::test
