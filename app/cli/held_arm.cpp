#include "app/cli/held_arm.h"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <utility>

#include "app/cli/arm_choice.h"
#include "app/cli/hands.h"
#include "app/cli/recording.h"
#include "app/cli/setting_overrides.h"
#include "app/options/scheduling_options.h"
#include "core/arm/preset.h"
#include "core/base/printed.h"
#include "core/scene/compile.h"
#include "core/scene/mirror.h"
#include "core/scene/scene_arm.h"
#include "core/sim/arm_model_file.h"
#include "core/sim/hand_script.h"
#include "device/catalogue.h"

namespace underact::cli {
namespace {

constexpr const char* kSimulated = "simulated";

/// "name: sentence" per line, for --help.
template <class Named, class Words>
std::string namedList(const char* title, std::span<const Named> named, Words Named::*what) {
  std::string list = title;
  for (const Named& one : named) list += std::string("\n  ") + one.name + ": " + one.*what;
  return list;
}

/// The scene with the given settings, with every control in that space (empty: as it is), and in the mirror where it is
/// for the left hand.
Result<LoadedScene> asAsked(LoadedScene loaded, const HeldArm& options) {
  if (options.space.empty() && !options.left_handed && options.overrides.empty()) return loaded;
  Result<scene::Description> changed = withOverrides(std::move(loaded.description), options.overrides);
  if (!changed) return changed.problems();
  loaded.description = std::move(changed).value();
  if (options.left_handed) loaded.description = scene::mirrored(std::move(loaded.description));
  if (!options.space.empty()) {
    const tick::Space wanted = options.space == "joint" ? tick::Space::Joint : tick::Space::Cartesian;
    loaded.description.control.space = wanted;
    for (scene::Constraint& constraint : loaded.description.constraints) {
      if (constraint.control) constraint.control->space = wanted;
    }
  }
  Result<tick::TickProgram> program = scene::compile(loaded.description);
  if (!program) return program.problems();
  loaded.program = std::move(program).value();
  return loaded;
}

/// The hand with the options' mass, damping and stiffness in place of its own.
sim::HandScript asHeld(sim::HandScript script, const HeldArm& options) {
  sim::HandModel& hand = script.hand;
  hand.mass_kg = options.mass_kg.value_or(hand.mass_kg);
  hand.damping_N_s_per_m = options.damping_N_s_per_m.value_or(hand.damping_N_s_per_m);
  hand.stiffness_N_per_m = options.stiffness_N_per_m.value_or(hand.stiffness_N_per_m);
  return script;
}

/// Why the options are not compatible; empty: they are.
std::string wrongIn(const HeldArm& options) {
  if (options.isSimulated())
    return options.hand.empty() ? "--hand: somebody has to hold the simulated arm. Give a built-in hand, or a file."
                                : "";
  if (!options.hand.empty())
    return "--hand: only the simulated arm has a scripted hand; you hold this arm yourself. Omit --hand.";
  return options.fast ? "--fast: only the simulated arm can run faster than real time. Omit --fast." : "";
}

}  // namespace

bool HeldArm::isSimulated() const {
  return device == kSimulated;
}

std::string fileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::optional<Prepared> prepare(const HeldArm& options, std::int64_t ticks, const Streams& streams, Exit& exit) {
  if (const std::string wrong = wrongIn(options); !wrong.empty()) {
    streams.err << printed(wrong) << '\n';
    exit = Exit::Usage;
    return {};
  }
  if (const Problems problems = Recording::check(options.record, options.existing()); !problems.empty()) {
    exit = fail(problems, Exit::File, streams);
    return {};
  }
  Result<LoadedScene> scene = loadScene(options.scene, streams);
  if (!scene) {
    exit = fail(scene.problems(), streams);
    return {};
  }
  printNotes(scene.value(), streams.err);
  Result<LoadedScene> asked = asAsked(std::move(scene).value(), options);
  if (!asked) {
    exit = fail(asked.problems(), Exit::BadInput, streams);
    return {};
  }
  if (!options.isSimulated()) return Prepared{std::move(asked).value(), {}};
  Result<sim::HandScript> hand = findHand(options.hand, options.seed);
  if (!hand) {
    exit = fail(hand.problems(), exitOfHand(options.hand, hand.problems()), streams);
    return {};
  }
  Result<sim::ArmModel> model = sim::chooseArmModel(options.arm_model);
  if (!model) {
    exit = fail(model.problems(), streams);
    return {};
  }
  Prepared prepared{std::move(asked).value(), {}};
  prepared.run = {fileName(options.hand),
                  contentOfHand(options.hand),
                  asHeld(sim::madeFor(scene::armOf(prepared.scene.description), std::move(hand).value()), options),
                  sim::modelFor(scene::armOf(prepared.scene.description), std::move(model).value()),
                  ticks,
                  options.fast,
                  options.seed};
  return prepared;
}

Result<std::unique_ptr<servo::DevicePort>> openArm(const HeldArm& options, const Prepared& prepared) {
  if (!options.isSimulated()) {
    const arm::Preset& preset = scene::armOf(prepared.scene.description);
    return device::openDevice(options.device, {preset, {}, options.rate_hz, {}});
  }
  const scene::Description& scene = prepared.scene.description;
  return std::unique_ptr<servo::DevicePort>(
      device::makeSimulatedArm(prepared.run, scene::armOf(scene), scene, options.rate_hz));
}

void addHandOptions(Command command, HeldArm& options) {
  const Option hand =
      command.option("--hand", options.hand, "The hand that holds the simulated arm: a built-in hand, or a hand file");
  command.option("--mass_kg", options.mass_kg, "Mass of the hand, kg, instead of its own").range(1e-3, 1e3).needs(hand);
  command.option("--damping_N_s_per_m", options.damping_N_s_per_m, "Damping of the hand, N s/m, instead of its own")
      .range(0.0, 1e6)
      .needs(hand);
  command.option("--stiffness_N_per_m", options.stiffness_N_per_m, "Stiffness of the hand, N/m, instead of its own")
      .range(0.0, 1e9)
      .needs(hand);
}

void addRateOptions(Command command, HeldArm& options) {
  command
      .option("--max-late", options.max_late,
              "Permitted number of consecutive ticks that are a whole period late; more are a fault")
      .showDefault()
      .range(1, 1'000'000);
  command.option("--rate", options.rate_hz, "Ticks per second").showDefault().range(100, 10000);
}

void addSeedOption(Command command, HeldArm& options) {
  command.option("--seed", options.seed, "Seed of everything that is random").showDefault().nonNegative();
}

void addArmOptions(Command command, HeldArm& options) {
  command.option("--space", options.space, "Space of the control, instead of the scene's")
      .oneOf({"cartesian", "joint"});
  addSet(command, options.overrides, "Another value of a setting of the scene, as in --set kp_N_per_mm=0.02");
  command.flag("--left-handed", options.left_handed, "Mirror the scene, for the stylus in the left hand");
  command
      .option("--device", options.device,
              "The arm, KIND or KIND:ADDRESS, as underact-cli devices lists it; it exerts force at once")
      .showDefault();
  addArmModelOption(command, options.arm_model);
  options::addSchedulingOptions(command, options.scheduling);
  command.footer(namedList("Hands:", sim::builtInHands(), &sim::BuiltInHand::what) + "\n" +
                 namedList("Arm models:", sim::armModels(), &sim::ArmModel::title));
}

}  // namespace underact::cli
