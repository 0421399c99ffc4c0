#include "core/arm/preset.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/arm/apparent_mass.h"
#include "core/arm/mechanism.h"
#include "core/arm/model.h"
#include "core/base/translate.h"

namespace underact::arm {
namespace {

constexpr double kGrip_m = 0.1;           // a moment that is not stated: that of the force at a hand's grip
constexpr double kUnstatedForce_N = 5.0;  // of an arm whose file does not say: what a hand on it takes for granted

std::shared_ptr<const Mechanism> mechanismOf(const Model& model) {
  Mechanism arm;
  arm.chain = model.chain;
  arm.masses = model.masses;
  arm.X_WB = model.X_WB;
  for (std::size_t joint = 0; joint < model.joints.size(); ++joint) {
    const auto& [min, max] = std::pair{model.rows[joint].min, model.rows[joint].max};
    arm.driven[joint] = model.joints[joint].driven;
    arm.max_torque[joint] = model.joints[joint].max_torque.value_or(0.0);
    arm.rest[joint] = model.joints[joint].rest.value_or(std::clamp(0.0, min, max));
  }
  arm.renders_moment = rendersMoment(arm);
  const double force_N = model.device ? model.device->continuous_force_N : kUnstatedForce_N;
  const double stated_N_m = model.device ? model.device->continuous_moment_N_m : 0.0;
  arm.max_moment_N_m = stated_N_m > 0.0 ? stated_N_m : kGrip_m * force_N;
  return std::make_shared<const Mechanism>(std::move(arm));
}

/// Whether the motors are those of the Omni: joints 1 to 3, and no more.
bool drivesFirstThree(const Model& model) {
  for (std::size_t joint = 0; joint < model.joints.size(); ++joint) {
    if (model.joints[joint].driven != (joint < 3)) return false;
  }
  return true;
}

std::vector<Preset> all() {
  std::vector<Preset> all;
  for (const Model& model : models()) {
    if (Result<Preset> preset = presetOf(model)) all.push_back(std::move(preset).value());
  }
  std::stable_partition(all.begin(), all.end(), isDevice);
  return all;
}

}  // namespace

Result<Preset> presetOf(const Model& model) {
  const std::optional<Geometry> geometry = omniGeometry(model);
  Preset preset{model.name, model.title, model.provenance, {}, limitsOf(model), {}, kUnstatedForce_N, 0.0};
  if (model.device) {
    preset.counts_per_turn = model.device->counts_per_turn;
    preset.continuous_force_N = model.device->continuous_force_N;
  }
  if (geometry && model.device && drivesFirstThree(model)) {
    preset.geometry = *geometry;
    preset.geometry.mechanism = mechanismOf(model);
    preset.apparent_mass_kg = apparentMass_kg(model);
    return preset;
  }
  if (geometry && !model.device) {
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "The arm of a scene with the geometry of table 3.1 of the thesis is a haptic device, "
                               "which needs %1 and %2 here: %3."),
                {"\"encoder_counts_per_turn\"", "\"continuous_force_N\"",
                 R"("device": {"encoder_counts_per_turn": [4096, 4096, 4096, 4096, 4096, 4096], )"
                 R"("continuous_force_N": 1})"})}};
  }
  for (std::size_t joint = 0; joint < model.joints.size(); ++joint) {
    if (model.joints[joint].sensed) continue;
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "Joint %1 is not sensed, so that the position of the tip would be unknown: "
                                           "the arm of a scene needs each of its joints sensed."),
                            {std::to_string(joint + 1)})}};
  }
  preset.geometry.mechanism = mechanismOf(model);
  preset.geometry.by_chain = true;
  preset.limits.of_wrist_size = model.limits_wrist_size;
  if (model.rows.size() < 5) preset.limits.min_rad[4] = -kInfinity;
  return preset;
}

std::span<const Preset> sceneArms() {
  static const std::vector<Preset> kAll = all();
  return kAll;
}

std::span<const Preset> presets() {
  const std::span<const Preset> every = sceneArms();
  return every.first(static_cast<std::size_t>(std::count_if(every.begin(), every.end(), isDevice)));
}

const Preset* findPreset(std::string_view name) {
  const std::span<const Preset> every = sceneArms();
  const auto found =
      std::find_if(every.begin(), every.end(), [&](const Preset& preset) { return name == preset.name; });
  return found == every.end() ? nullptr : &*found;
}

}  // namespace underact::arm
