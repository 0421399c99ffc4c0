#pragma once
#include <string>

namespace underact::test {

/// An arm file of the Omni's form; what a device needs begins in line 13.
inline std::string armFileWithoutDevice(const std::string& upper_mm, const std::string& device = "") {
  return R"({
  "underact_arm": 1,
  "name": "mine", "title": "An arm of my own", "provenance": "Measured by hand.",
  "dh": [
    {"alpha_deg": 0, "a_mm": 0, "d_mm": 0, "min_rad": -0.75, "max_rad": 0.75},
    {"alpha_deg": 90, "a_mm": 0, "d_mm": 0, "min_rad": 0, "max_rad": 1.75},
    {"alpha_deg": 0, "a_mm": )" +
         upper_mm + R"(, "d_mm": 0, "min_rad": -0.81, "max_rad": 1.25},
    {"alpha_deg": 90, "a_mm": 0, "d_mm": 120, "min_rad": -2.5, "max_rad": 2.5},
    {"alpha_deg": -90, "a_mm": 0, "d_mm": 0, "min_rad": 0.62, "max_rad": 2.6, "limits_of_size": true},
    {"alpha_deg": 90, "a_mm": 0, "d_mm": 0, "min_rad": -2.25, "max_rad": 2.25}
  ],
  "X_WB": [[0, 1, 0, 0], [0, 0, 1, 20], [1, 0, 0, -165], [0, 0, 0, 1]])" +
         device + "\n}\n";
}

inline std::string armFile(const std::string& upper_mm, const std::string& force_N = "0.9",
                           const std::string& force_key = "continuous_force_N") {
  return armFileWithoutDevice(upper_mm, R"(,
  "device": {
    "encoder_counts_per_turn": [8192, 8192, 8192, 4096, 4096, 4096],
    ")" + force_key + "\": " + force_N + "}");
}

}  // namespace underact::test
