#include "core/sim/arm_model.h"

#include <algorithm>
#include <array>

#include "core/arm/mechanism.h"

namespace underact::sim {
namespace {

const std::array<ArmModel, 2> kModels{
    ArmModel{"vendor-nominal", "Vendor's figures",
             "Apparent mass 45 g and back-drive friction below 0.26 N from the vendor's sheets, not traced to a test; "
             "gravity "
             "taken as balanced, friction as Coulomb's and equal in all directions, which nobody measured.",
             0.045, 0.26, true},
    ArmModel{"ideal", "Ideal arm",
             "Made up for teaching: no mass, no friction, exact angles. No real arm is like this.", 0.0, 0.0, false}};

}  // namespace

arm::EncoderCounts countsOf(const arm::EncoderCounts& measured, const arm::EncoderCounts& preset) {
  arm::EncoderCounts counts = preset;
  for (std::size_t joint = 0; joint < counts.size(); ++joint) {
    if (measured[joint] > 0.0) counts[joint] = measured[joint];
  }
  return counts;
}

ArmModel modelFor(const arm::Preset& arm, ArmModel model) {
  if (model.name != kDefaultArmModel) return model;
  model.of_links = !arm::solvesInTick(arm.geometry) && !arm.geometry.mechanism->masses.empty();
  if (model.of_links)
    model.provenance = "Inertia of the links in the file of the arm " + arm.name +
                       "; back-drive friction below 0.26 N at the tip, as of the Omni by its vendor's sheets.";
  if (!(arm.apparent_mass_kg > 0.0)) return model;
  model.mass_kg = arm.apparent_mass_kg;
  model.provenance = "Apparent mass of the links in the file of the arm " + arm.name +
                     ", with the tip in the middle of the workspace; back-drive friction below 0.26 N from the "
                     "vendor's sheets, taken as Coulomb's and equal in all directions.";
  return model;
}

std::span<const ArmModel> armModels() {
  return kModels;
}

const ArmModel* findArmModel(std::string_view name) {
  const auto* const found =
      std::find_if(kModels.begin(), kModels.end(), [&](const ArmModel& model) { return name == model.name; });
  return found == kModels.end() ? nullptr : found;
}

}  // namespace underact::sim
