#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/sim/arm_model.h"

namespace underact::sim {

/// The provenance of a measured arm model.
struct Provenance {
  std::string device;   // "Simulated arm"
  std::string serial;   // empty: it has none
  std::string date;     // 2026-11-22
  std::string program;  // "underact 0.1.0"
  std::string method;
  int rate_hz = 0;
  std::vector<Vec3> places_mm;
};

/// One standard deviation of each.
struct ModelUncertainty {
  double mass_kg = 0.0;
  double friction_N = 0.0;
  double damping_N_s_per_m = 0.0;
};

/// An arm's model as its file says it. arm.provenance: the provenance in a sentence.
struct ArmModelFile {
  ArmModel arm;
  Provenance provenance;
  std::optional<ModelUncertainty> uncertainty = {};
};

/// {"underact_arm_model": 1, "name", "title", "provenance": {...}, "mass_kg", "friction_N", ...}; keys: the guide,
/// "Measure the arm". Problems: all at once, with places.
Result<ArmModelFile> readArmModel(std::string_view text, const std::string& file_name);
/// Reads a model's file. Problems, too: it cannot be read.
Result<ArmModelFile> readArmModelFile(const std::string& path);

/// The text of the file; readArmModel() reads the same back, number by number.
std::string armModelText(const ArmModelFile& file);

/// "Measured on ..., serial ..., on ...": what is shown beside the name.
std::string sentenceOf(const Provenance& provenance);

/// A shipped model by name, or (a name with a dot or a slash) one from a file. Problems: those of the file; no such
/// name, with the names there are.
Result<ArmModel> chooseArmModel(const std::string& name);

}  // namespace underact::sim
