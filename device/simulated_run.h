#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/json/json.h"
#include "core/json/object_text.h"
#include "core/scene/description.h"
#include "core/sim/arm_model.h"
#include "core/sim/hand_script.h"
#include "device/simulated_arm.h"

namespace underact::device {

/// What a run of the simulated arm is made from besides its scene: enough to make it again.
struct SimulatedRun {
  std::string hand_name;  // of a built-in hand, or of its file without folders
  std::string hand_file;  // that file's content; empty: a built-in hand
  sim::HandScript hand;
  sim::ArmModel model;
  std::int64_t ticks = 0;  // asked for
  bool fast = false;       // not in real time
  std::uint64_t seed = 0;  // of everything that is random
};

/// As a member of a session's provenance: {"run": {...}}; every number reads back to the same double.
json::ObjectText provenanceOf(const SimulatedRun& run);

/// The provenance of a run by a person's hand: {"run": {"made_by": ..., "arm_model": ...}}. model: of the simulated
/// arm; null: a real one.
json::ObjectText provenanceOfPerson(const sim::ArmModel* model);

/// The provenance of a run whose hand was a function in Python: it is made again from its recorded input, too.
json::ObjectText provenanceOfPython(const sim::ArmModel& model);

/// The provenance of a run that other programs steered: {"run": {"made_by": ..., "held_by": ..., "arm_model": ...}}. It
/// is made again from its recorded input, not from the hand. run: of the simulated arm; null: a real one.
json::ObjectText provenanceOfService(const SimulatedRun* run);

/// Whether a provenance has a run of the simulated arm that can be made again.
bool hasSimulatedRun(const json::Value& provenance);

/// Reads it back. Problems: it lacks a member, or has one of another kind. file: for their place.
Result<SimulatedRun> readSimulatedRun(const json::Value& provenance, const std::string& file);

/// The simulated arm of that run, in the hand that holds it.
std::unique_ptr<SimulatedArm> makeSimulatedArm(const SimulatedRun& run, const arm::Preset& arm,
                                               const scene::Description& scene, int rate_hz);

}  // namespace underact::device
