#include "core/arm/preset.h"

#include <algorithm>
#include <vector>

#include "core/arm/model.h"

namespace underact::arm {
namespace {

std::vector<Preset> devices() {
  std::vector<Preset> all;
  for (const Model& model : models()) {
    const std::optional<Geometry> geometry = omniGeometry(model);
    if (!model.device || !geometry) continue;
    all.push_back({model.name, model.title, model.provenance, *geometry, limitsOf(model), model.device->counts_per_turn,
                   model.device->continuous_force_N});
  }
  return all;
}

}  // namespace

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
