#include "device/lesson_trial.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/arm/preset.h"
#include "core/json/json.h"
#include "core/json/object_reader.h"
#include "core/scene/fields.h"
#include "core/scene/read.h"
#include "core/servo/host.h"
#include "device/simulated_arm.h"

namespace underact::device {
namespace {

constexpr int kRate_hz = 1000;
constexpr std::int64_t kTicksAtOnce = 16;  // a frame of the window: between two of them a robot's joints hardly move
constexpr double kAfterwards_s = 1.0;

template <class Enum, std::size_t kCount>
bool setWord(const json::Word<Enum> (&words)[kCount], const std::string& value, Enum& into) {
  for (const json::Word<Enum>& word : words) {
    if (value != word.word) continue;
    into = word.value;
    return true;
  }
  return false;
}

bool setGain(const LessonSetting& setting, scene::Gains& gains) {
  const Result<json::Value> number = json::parse(setting.value, "");
  if (!number || number.value().kind != json::Kind::Number) return false;
  for (const scene::GainField& field : scene::kGainFields) {
    if (setting.key == field.key) (gains.*field.member).setConstant(number.value().number);
  }
  return true;
}

bool setControl(const LessonSetting& setting, scene::Control& control) {
  if (setting.key == "law") return setWord(scene::kLawWords, setting.value, control.law);
  if (setting.key == "passivity") return setWord(scene::kPassivityWords, setting.value, control.passivity);
  return setGain(setting, control.gains);
}

/// The influence, or a virtual manipulator's turning stiffness.
bool setNumber(const LessonSetting& setting, scene::Description& scene) {
  const Result<json::Value> number = json::parse(setting.value, "");
  if (!number || number.value().kind != json::Kind::Number) return false;
  bool any = false;
  for (scene::Constraint& constraint : scene.constraints) {
    auto* const robot = std::get_if<scene::VirtualManipulator>(&constraint.shape);
    if (setting.key == "t" && constraint.influence) {
      constraint.influence->t = number.value().number;
      any = true;
    } else if (setting.key != "t" && robot != nullptr) {
      robot->ko_N_mm_per_rad = number.value().number;
      any = true;
    }
  }
  return any;
}

Problems refused(const LessonSetting& setting, const std::string& why) {
  return {{"The setting " + setting.key + "=" + setting.value + " " + why, {"the settings", 1, 0, setting.key}}};
}

/// Asks each check, tick by tick.
class Watching {
 public:
  Watching(const lesson::Step& step, const scene::Description& scene)
      : step_(step), scene_(scene), arm_(*arm::findPreset(scene.arm)), states_(step.checks.size()) {}

  void look(servo::Host& host) {
    const target::Robot robot = robotOf(host.snapshot().report);
    host.drain([&](const servo::TickRecord& record) {
      const lesson::Seen seen{record, scene_, arm_, robot};
      for (std::size_t index = 0; index < states_.size(); ++index) {
        states_[index] = lesson::afterTick(step_.checks[index], std::move(states_[index]), seen);
      }
    });
  }

  /// Problems: there are more answers than questions.
  Problems answer(const std::vector<double>& answers) {
    std::size_t next = 0;
    for (std::size_t index = 0; index < states_.size() && next < answers.size(); ++index) {
      if (lesson::questionOf(step_.checks[index]) == nullptr) continue;
      states_[index] = lesson::afterAnswer(step_.checks[index], std::move(states_[index]), answers[next++]);
    }
    if (next == answers.size()) return {};
    return {{"There are more answers than the step has questions.", {"the answers", 1, 0, ""}}};
  }

  std::vector<lesson::CheckState> take() { return std::move(states_); }

 private:
  static target::Robot robotOf(const tick::TickReport& report) {
    for (const tick::Held& held : report.held) {
      if (held.robot.joints > 0) return held.robot;
    }
    return {};
  }

  const lesson::Step& step_;
  const scene::Description& scene_;
  const arm::Preset& arm_;
  std::vector<lesson::CheckState> states_;
};

}  // namespace

Result<scene::Description> withSetting(scene::Description scene, const LessonSetting& setting) {
  const bool is_gain = std::any_of(std::begin(scene::kGainFields), std::end(scene::kGainFields),
                                   [&](const scene::GainField& field) { return setting.key == field.key; });
  bool done = false;
  if (is_gain || setting.key == "law" || setting.key == "passivity") {
    done = setControl(setting, scene.control);
    for (scene::Constraint& constraint : scene.constraints) {
      if (constraint.control) done = setControl(setting, *constraint.control) && done;
    }
  } else if (setting.key == "t" || setting.key == "ko_N_mm_per_rad") {
    done = setNumber(setting, scene);
  } else {
    return refused(setting,
                   "is none: there are law, kp_N_per_mm, kd_N_s_per_mm, ki_N_per_mm_s, passivity, t and "
                   "ko_N_mm_per_rad.");
  }
  if (!done) return refused(setting, "says nothing to this scene.");
  if (const Problems problems = scene::check(scene); !problems.empty())
    return refused(setting, "is not possible: " + problems.front().sentence);
  return scene;
}

Result<LessonOutcome> tryLessonStep(const lesson::Step& step, scene::Description scene, const LessonAttempt& attempt) {
  for (const LessonSetting& setting : attempt.settings) {
    Result<scene::Description> set = withSetting(std::move(scene), setting);
    if (!set) return set.problems();
    scene = std::move(set).value();
  }
  SimulatedArm::Options options;
  options.arm = *arm::findPreset(scene.arm);
  options.model = attempt.model;
  options.hand = attempt.hand.hand;
  options.rate_hz = kRate_hz;
  options.integration = integrationOf(scene.simulation);
  auto arm = std::make_unique<SimulatedArm>(options);
  arm->follow(attempt.hand);
  servo::Host host(std::move(arm), {.rate_hz = kRate_hz, .clock = servo::Clock::Manual});
  if (const Problems problems = host.load(scene); !problems.empty()) return problems;
  if (attempt.starts) host.start();
  const double seconds = attempt.seconds > 0.0 ? attempt.seconds : attempt.hand.path.back().t_s + kAfterwards_s;
  const std::int64_t ticks = std::llround(seconds * kRate_hz);
  Watching watching(step, scene);
  for (std::int64_t done = 0; done < ticks; done += kTicksAtOnce) {
    host.run(std::min(kTicksAtOnce, ticks - done));
    watching.look(host);
  }
  if (const Problems problems = watching.answer(attempt.answers); !problems.empty()) return problems;
  LessonOutcome outcome{watching.take()};
  if (const std::optional<servo::FaultReport> fault = host.takeFault()) outcome.fault = fault->fault;
  return outcome;
}

}  // namespace underact::device
