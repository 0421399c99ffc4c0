#pragma once
#include <string>
#include <vector>

#include "core/scene/description.h"

namespace underact::tradeoff {

/// All choices between speed and accuracy; at first the program's defaults.
struct Settings {
  int rate_hz = 1000;
  Search search = Search::Hybrid;  // of meshes and curves
  scene::Solver solver;            // of robots
  scene::Velocity velocity;        // of laws that damp
  scene::Simulation simulation;    // of the arm, where it is simulated
  double block_s = 0.1;            // of a recording
  int inverse_steps = 0;           // of the arm's inverse kinematics by iteration; 0: in closed form
  bool operator==(const Settings&) const = default;
};

/// The settings of a scene, at the rate of the servo; of several meshes, robots or laws those of the first.
Settings settingsOf(const scene::Description& scene, int rate_hz);

/// The scene with these settings, the same for all its constraints.
scene::Description withSettings(scene::Description scene, const Settings& settings);

// Whether a setting applies to a scene.
bool hasSearch(const scene::Description& scene);
bool hasSolver(const scene::Description& scene);
bool hasVelocity(const scene::Description& scene);

/// One difference in words: "servo rate", "1000 Hz", "4000 Hz".
struct Difference {
  std::string what, before, after;
};

/// The differences between two settings that apply to the scene.
std::vector<Difference> differences(const scene::Description& scene, const Settings& before, const Settings& after);

}  // namespace underact::tradeoff
