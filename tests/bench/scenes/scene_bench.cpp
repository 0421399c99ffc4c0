#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/servo/host.h"
#include "core/sim/arm_model.h"
#include "core/sim/hand_script.h"
#include "device/simulated_arm.h"

// Usage: underact-scene-bench [SECONDS] [RATE_HZ] [HAND]. us that a tick takes (kinematics, targets, laws, gate, the
// force written) in the servo thread, waking for each one as it does for a hand: colder caches than in a loop without a
// pause. Every scene that ships.
namespace underact {
namespace {

std::vector<std::filesystem::path> shippedScenes() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(UNDERACT_SOURCE) / "scenes")) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".json") && !name.ends_with(".schema.json")) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// false: the scene, the hand or the run was not right, and that has been told.
bool measure(const std::filesystem::path& path, int seconds, int rate_hz, const std::string& hand_name) {
  Result<scene::Description> scene = scene::readSceneFile(path.string());
  if (scene) (void)scene::loadMeshes(scene.value());
  Result<sim::HandScript> hand = sim::builtInHand(hand_name, 1);
  if (!scene || !hand) {
    std::printf("%s: not read\n", (scene ? hand_name : path.string()).c_str());
    return false;
  }
  device::SimulatedArm::Options options;
  options.arm = *arm::findPreset(scene.value().arm);
  options.model = *sim::findArmModel(sim::kDefaultArmModel);
  options.hand = hand.value().hand;
  options.rate_hz = rate_hz;
  auto arm = std::make_unique<device::SimulatedArm>(options);
  arm->follow(std::move(hand).value());
  servo::Host host(std::move(arm), {.rate_hz = rate_hz, .clock = servo::Clock::Thread});
  if (!host.load(scene.value()).empty()) return false;
  host.start();
  host.begin();
  std::int64_t ticks = 0;
  bool faulted = false;
  while (ticks < std::int64_t{seconds} * rate_hz) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    host.drain([&](const servo::TickRecord& record) {
      ++ticks;
      faulted = faulted || record.fault != FaultKind::None;
    });
  }
  const servo::Percentiles took = host.timing().tickTime();
  std::printf("%-28s %8.1f %8.1f %8.1f %8.1f%s\n", path.stem().c_str(), took.p50_us, took.p99_us, took.p999_us,
              took.max_us, faulted ? "  (with a fault)" : "");
  std::fflush(stdout);
  return true;
}

}  // namespace
}  // namespace underact

int main(int argc, char** argv) {
  const int seconds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 10;
  const int rate_hz = argc > 2 ? std::clamp(std::atoi(argv[2]), 100, 10'000) : 1000;
  const std::string hand = argc > 3 ? argv[3] : "sweep";
  std::printf("%d s each at %d Hz, hand %s; us a tick\n%-28s %8s %8s %8s %8s\n", seconds, rate_hz, hand.c_str(),
              "scene", "p50", "p99", "p99.9", "max");
  bool well = true;
  for (const std::filesystem::path& path : underact::shippedScenes()) {
    well = underact::measure(path, seconds, rate_hz, hand) && well;
  }
  return well ? 0 : 1;
}
