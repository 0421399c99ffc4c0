#pragma once
#include <span>
#include <string_view>

namespace underact::sim {

/// What the simulated arm is made of, as felt at the tip.
struct ArmModel {
  const char* name = "";
  const char* title = "";
  const char* provenance = "";
  double mass_kg = 0.0;     // apparent, at the tip
  double friction_N = 0.0;  // Coulomb, back-drive, at the tip
  bool encoders = true;     // angles come in steps; false: exact
};

std::span<const ArmModel> armModels();

/// The model of that name, or null.
const ArmModel* findArmModel(std::string_view name);

inline constexpr std::string_view kDefaultArmModel = "vendor-nominal";

}  // namespace underact::sim
