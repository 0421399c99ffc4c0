#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/arm/preset.h"

namespace underact::sim {

/// The dynamics of the simulated arm, as felt at the tip.
struct ArmModel {
  std::string name = {};
  std::string title = {};
  std::string provenance = {};
  double mass_kg = 0.0;                                    // apparent, at the tip
  double friction_N = 0.0;                                 // Coulomb, back-drive, at the tip
  bool encoders = true;                                    // angles come in steps; false: exact
  bool of_links = false;                                   // the mass is that of the links in the arm's file, if any
  double damping_N_s_per_m = 0.0;                          // of the arm itself, at the tip
  std::optional<arm::EncoderCounts> counts_per_turn = {};  // as measured, 0 where not; none: those of the preset
};

/// The measured counts; where one was not measured (0), that of the preset.
arm::EncoderCounts countsOf(const arm::EncoderCounts& measured, const arm::EncoderCounts& preset);

/// The model as it simulates that arm: the default model takes the mass that the arm's file gives, if it gives one;
/// every other model keeps its own. The same again changes nothing.
ArmModel modelFor(const arm::Preset& arm, ArmModel model);

/// The models that ship with the program.
std::span<const ArmModel> armModels();

/// The model of that name, or null.
const ArmModel* findArmModel(std::string_view name);

inline constexpr std::string_view kDefaultArmModel = "vendor-nominal";

}  // namespace underact::sim
