#include "device/lesson_attempt.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/arm/preset.h"
#include "core/lesson/stage.h"
#include "core/scene/read.h"
#include "core/scene/scene_arm.h"
#include "core/scene/settings.h"
#include "core/servo/host.h"
#include "device/simulated_arm.h"

namespace underact::device {
namespace {

constexpr int kRate_hz = 1000;
constexpr std::int64_t kTicksAtOnce = 16;  // a frame of the window: a robot's joints hardly move in it
constexpr double kAfterwards_s = 1.0;

Problems refused(const LessonSetting& setting, const std::string& why) {
  return {{"The setting " + setting.key + "=" + setting.value + " " + why, {"the settings", 1, 0, setting.key}}};
}

/// Evaluates each check, tick by tick.
class Watching {
 public:
  Watching(const lesson::Step& step, const scene::Description& scene)
      : step_(step), scene_(scene), arm_(scene::armOf(scene)), states_(step.checks.size()) {}

  void poll(servo::Host& host) {
    const target::Robot robot = robotOf(host.snapshot().report);
    host.drain([&](const servo::TickRecord& record) {
      const lesson::Observation seen{record, scene_, arm_, robot};
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
    return {{"There are more answers than questions in the step.", {"the answers", 1, 0, ""}}};
  }

  std::vector<lesson::CheckState> take() { return std::move(states_); }

 private:
  static target::Robot robotOf(const tick::TickReport& report) {
    for (const tick::ConstraintReport& held : report.held) {
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

Result<scene::Description> withSetting(const scene::Description& scene, const LessonSetting& setting) {
  if (scene::everywhere(setting.key).empty() && scene::findSetting(setting.key) == nullptr)
    return refused(setting, "is none; the guide's page of scene files has all there are, law and kp_N_per_mm, say.");
  Result<scene::Description> set = scene::withText(scene, setting.key, setting.value);
  if (!set) return refused(setting, "is not possible: " + set.problems().front().sentence);
  if (const Problems problems = scene::check(set.value()); !problems.empty())
    return refused(setting, "is not possible: " + problems.front().sentence);
  return set;
}

LessonDesk::LessonDesk(const sim::ArmModel& model) : model_(model) {}

LessonDesk::~LessonDesk() = default;

Result<LessonOutcome> LessonDesk::tryStep(const lesson::Step& step, scene::Description scene,
                                          const LessonAttempt& attempt) {
  for (const LessonSetting& setting : attempt.settings) {
    Result<scene::Description> set = withSetting(scene, setting);
    if (!set) return set.problems();
    scene = std::move(set).value();
  }
  const bool is_touched = !attempt.hand.path.empty();
  const arm::Preset& preset = scene::armOf(scene);
  if (host_ == nullptr) {
    SimulatedArm::Options options;
    options.arm = preset;
    options.model = model_;
    options.hand = attempt.hand.hand;
    options.rate_hz = kRate_hz;
    options.start_p_WT = kFirst_p_WT;
    options.integration = integrationOf(scene.simulation);
    auto arm = std::make_unique<SimulatedArm>(options);
    arm_ = arm.get();
    host_ = std::make_unique<servo::Host>(std::move(arm),
                                          servo::HostOptions{.rate_hz = kRate_hz, .clock = servo::Clock::Manual});
    if (is_touched) arm_->follow(attempt.hand);
  } else {
    arm_->integrate(integrationOf(scene.simulation));
    arm_->become(preset);
    arm_->standAt(lesson::startOf(step, preset));
    if (is_touched) {
      arm_->follow(attempt.hand);
    } else {
      sim::HandSetpoint loose = arm_->setpoint();  // ends the script of the step before
      loose.holds = false;
      arm_->setSetpoint(loose);
    }
  }
  if (const Problems problems = host_->load(scene); !problems.empty()) return problems;
  if (attempt.starts) {
    host_->start();
  } else {
    host_->stop();
  }
  const double seconds =
      attempt.seconds > 0.0 || !is_touched ? attempt.seconds : attempt.hand.path.back().t_s + kAfterwards_s;
  const std::int64_t ticks = std::llround(seconds * kRate_hz);
  Watching watching(step, scene);
  host_->drain([](const servo::TickRecord&) {});  // of the step before
  for (std::int64_t done = 0; done < ticks; done += kTicksAtOnce) {
    host_->run(std::min(kTicksAtOnce, ticks - done));
    watching.poll(*host_);
  }
  if (const Problems problems = watching.answer(attempt.answers); !problems.empty()) return problems;
  LessonOutcome outcome{watching.take()};
  if (const std::optional<servo::FaultReport> fault = host_->takeFault()) outcome.fault = fault->fault;
  return outcome;
}

Result<LessonOutcome> tryLessonStep(const lesson::Step& step, scene::Description scene, const LessonAttempt& attempt) {
  return LessonDesk(attempt.model).tryStep(step, std::move(scene), attempt);
}

}  // namespace underact::device
