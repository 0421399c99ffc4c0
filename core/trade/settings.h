#pragma once
#include <string>
#include <vector>

#include "core/scene/description.h"

namespace underact::trade {

/// All that the program lets one choose between speed and accuracy. Each is the program's own default at first.
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

/// What a scene says, at the rate of the servo; of several meshes, robots or laws the first that there is.
Settings settingsOf(const scene::Description& scene, int rate_hz);

/// The scene with these, for all its constraints alike.
scene::Description withSettings(scene::Description scene, const Settings& settings);

// What a scene has that a setting is of.
bool hasSearch(const scene::Description& scene);
bool hasSolver(const scene::Description& scene);
bool hasVelocity(const scene::Description& scene);

/// One thing that differs, in words: "servo rate", "1000 Hz", "4000 Hz".
struct Difference {
  std::string what, before, after;
};

/// What differs for the scene between two settings; what it has no use for is left out.
std::vector<Difference> differences(const scene::Description& scene, const Settings& before, const Settings& after);

}  // namespace underact::trade
