#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/stability/scene_trial.h"
#include "core/stability/wall.h"

namespace underact::stability {

// Stability maps: the greatest stiffness of a wall against its damping B, under various conditions. The cells of a map
// are independent, so any number of machines may compute them.

/// One wall of a map, whose axes are B and K.
struct Variant {
  std::string name;  // "1000 Hz"
  SampledWall wall;
};

/// The effect of one condition on the limit: rate, delay, hand, filter, quantization, friction.
struct WallMap {
  const char* key;
  const char* title;
  std::vector<Variant> variants;
};

/// Of the arm's nominal mass with 0.1 N s/m, if the map does not say otherwise.
std::span<const WallMap> wallMaps();

std::span<const double> mapDampings_N_s_per_m();   // B
std::span<const double> mapStiffnesses_N_per_m();  // K, where cells are labelled

/// The nominal stiffness of the arm, N/m, which a map marks at B = 0.
inline constexpr double kNominal_N_per_m = 500.0;

/// The limits of K for one B.
struct Limits {
  double simulated_N_per_m = 0.0;       // in the loop
  std::optional<double> exact_N_per_m;  // by eigenvalues; none: the wall is not linear, or nothing limits it
  double passive_N_per_m = 0.0;         // for any hand: wall and damping alone, without friction and steps
  double colgate_schenkel_N_per_m = 0.0;
  double gil_hulin_N_per_m = 0.0;
};
/// All of them, each by its own method; wall.kd_N_s_per_m is the B they hold for. Takes a simulation of many trials.
Limits limitsOf(const SampledWall& wall);

/// The result for one cell of B and K.
struct Label {
  TrialResult trial;
  bool is_passive = false;  // of the linear wall, for any hand
};
/// wall as in limitsOf(), which gave the limits; K: above 0. Takes one simulated trial, see tryWall().
Label labelOf(const SampledWall& wall, const Limits& limits, double stiffness_N_per_m);

/// The rates and dampings at which scenes are tried.
std::span<const int> sceneRates_hz();
/// See sceneRates_hz(); the damping is the law's kd.
std::span<const double> sceneDampings_N_s_per_m();
std::span<const double> sceneStiffnesses_N_per_m();  // where cells are labelled

}  // namespace underact::stability
