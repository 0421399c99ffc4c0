#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/record/recorder.h"
#include "core/scene/description.h"
#include "core/servo/host.h"
#include "core/tick/program.h"
#include "tests/support/random.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {

/// All scenes that ship, by their paths.
std::vector<std::string> shippedScenes();
scene::Description sceneAt(const std::string& path);
scene::Description sphereScene();
tick::TickProgram programOf(const scene::Description& scene);

/// A servo on the simulated arm, held by a built-in hand.
std::unique_ptr<servo::Host> makeHost(servo::Clock clock, const std::string& hand, int rate_hz = 1000,
                                      std::uint64_t seed = 1);

/// Records `ticks` of a servo that is in the midst of it, with starts, stops, edits of gains and targets, and a load,
/// all drawn from the seed.
void recordEvents(const std::string& path, const scene::Description& scene, const std::string& hand, Seed seed);

}  // namespace underact::test
