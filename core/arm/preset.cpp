#include "core/arm/preset.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/arm/apparent_mass.h"
#include "core/arm/model.h"

namespace underact::arm {
namespace {

std::vector<Preset> devices() {
  std::vector<Preset> all;
  for (const Model& model : models()) {
    if (std::optional<Preset> preset = presetOf(model)) all.push_back(std::move(*preset));
  }
  return all;
}

}  // namespace

std::optional<Preset> presetOf(const Model& model) {
  const std::optional<Geometry> geometry = omniGeometry(model);
  if (!model.device || !geometry) return {};
  return Preset{model.name,
                model.title,
                model.provenance,
                *geometry,
                limitsOf(model),
                model.device->counts_per_turn,
                model.device->continuous_force_N,
                apparentMass_kg(model)};
}

std::span<const Preset> presets() {
  static const std::vector<Preset> kAll = devices();
  return kAll;
}

const Preset* findPreset(std::string_view name) {
  const std::span<const Preset> every = presets();
  const auto found =
      std::find_if(every.begin(), every.end(), [&](const Preset& preset) { return name == preset.name; });
  return found == every.end() ? nullptr : &*found;
}

}  // namespace underact::arm
