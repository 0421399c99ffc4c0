#include "app/bindings/simulation.h"

#include <algorithm>
#include <utility>

#include "core/scene/scene_arm.h"
#include "core/sim/arm_model_file.h"
#include "core/sim/hand_script.h"

namespace underact::bindings {
namespace {

constexpr std::int64_t kTicksAtOnce = 1000;  // far fewer than the servo keeps for us

/// What the simulated arm is held by and made of. Without a hand, the arm's own rest is where the hand is at first.
Result<device::SimulatedRun> runOf(const Scene& scene, const SimulationOptions& options) {
  device::SimulatedRun run;
  Result<sim::ArmModel> model = sim::chooseArmModel(options.arm_model);
  if (!model) return model.problems();
  const arm::Preset& preset = scene::armOf(scene.description);
  run.model = sim::modelFor(preset, std::move(model).value());
  run.fast = true;
  run.seed = options.seed;
  if (options.hand.empty() && options.hand_text.empty()) return run;
  Result<sim::HandScript> hand = options.hand_text.empty() ? sim::builtInHand(options.hand, options.seed)
                                                           : sim::readHand(options.hand_text, "hand.json");
  if (!hand) return hand.problems();
  run.hand_name = options.hand_text.empty() ? options.hand : "hand.json";
  run.hand_file = options.hand_text;
  run.hand = sim::madeFor(preset, std::move(hand).value());
  return run;
}

}  // namespace

Result<std::unique_ptr<Simulation>> Simulation::make(const Scene& scene, const SimulationOptions& options) {
  const Result<device::SimulatedRun> run = runOf(scene, options);
  if (!run) return run.problems();
  std::unique_ptr<Simulation> made(new Simulation());
  const arm::Preset& preset = scene::armOf(scene.description);
  const bool scripted = !run.value().hand.path.empty();
  std::unique_ptr<device::SimulatedArm> arm;
  if (scripted) {
    arm = device::makeSimulatedArm(run.value(), preset, scene.description, options.rate_hz);
  } else {
    arm = std::make_unique<device::SimulatedArm>(device::SimulatedArm::Options{
        preset, run.value().model, {}, options.rate_hz, {}, scene::integrationOf(scene.description.simulation)});
  }
  made->arm_ = arm.get();
  made->geometry_ = preset.geometry;
  made->host_ = std::make_unique<servo::Host>(
      std::move(arm), servo::HostOptions{.rate_hz = options.rate_hz, .clock = servo::Clock::Manual});
  Problems problems = made->host_->load(scene.description);
  if (!problems.empty()) return problems;
  made->host_->start();
  if (options.record.empty()) return made;
  record::RecorderOptions recording;
  recording.details = options.details;
  recording.run = scripted ? device::provenanceOf(run.value()) : device::provenanceOfPython(run.value().model);
  record::SessionMetadata words;
  words.name = options.name;
  Result<std::unique_ptr<record::Recorder>> recorder =
      record::Recorder::start(*made->host_, options.record, words, recording);
  if (!recorder) return recorder.problems();
  made->recorder_ = std::move(recorder).value();
  return made;
}

void Simulation::run(std::int64_t ticks) {
  for (std::int64_t left = ticks; left > 0;) {
    const std::int64_t now = std::min(left, kTicksAtOnce);
    host_->run(now);
    host_->drain([this](const servo::TickRecord& record) {
      last_ = record;
      ++count_;
      if (keeps) ticks_.push_back(record);
    });
    left -= now;
  }
}

void Simulation::want(const Vec3& p_WT, const Mat3* R_WT) {
  sim::HandSetpoint setpoint;
  setpoint.p_WT = p_WT;
  if (R_WT != nullptr) setpoint.R_WT = *R_WT;
  setpoint.turns = R_WT != nullptr;
  arm_->setSetpoint(setpoint);
}

Problems Simulation::edit(const Scene& scene) {
  return host_->edit(scene.description);
}

void Simulation::mark(const std::string& label) {
  if (recorder_) recorder_->mark(label);
}

Problems Simulation::close() {
  if (!recorder_) return {};
  Problems problems = recorder_->stop();
  recorder_.reset();
  return problems;
}

}  // namespace underact::bindings
