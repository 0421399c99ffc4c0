// underact-mesh-load-bench [SECONDS] [FACES]: whether the servo in the same process is late while a large mesh is read,
// repaired, and its tree is built; beside the same time with nothing to do, with as many threads as there are
// processors that only count, and with another process that only takes memory and gives it back: what those do to the
// servo is the machine's. Times are this machine's, now.
#include "core/mesh_file/load.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/scene/description.h"
#include "core/servo/host.h"
#include "core/sim/arm_model.h"
#include "core/sim/hand_script.h"
#include "device/simulated_arm.h"
#include "scenes/meshes/make/meshes.h"
#include "scenes/meshes/make/write.h"

namespace underact {
namespace {

std::unique_ptr<servo::Host> runningHost() {
  sim::HandScript hand = sim::builtInHand("sweep", 1).value();
  device::SimulatedArm::Options options;
  options.arm = *arm::findPreset(arm::kDefaultArm);
  options.model = *sim::findArmModel(sim::kDefaultArmModel);
  options.hand = hand.hand;
  options.rate_hz = 1000;
  auto arm = std::make_unique<device::SimulatedArm>(options);
  arm->follow(std::move(hand));
  auto host =
      std::make_unique<servo::Host>(std::move(arm), servo::HostOptions{.rate_hz = 1000, .clock = servo::Clock::Thread});
  scene::Description scene;
  scene.title = "Ball";
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 40.0}, target::Side::Outside, {}, {}});
  if (!host->load(scene).empty()) return nullptr;
  host->start();
  host->begin();
  return host;
}

/// Keeps every processor busy for so long, without memory, files or locks.
void onlyCount(double seconds) {
  std::atomic<bool> ended{false};
  std::vector<std::jthread> threads;
  for (unsigned k = 0; k < std::thread::hardware_concurrency(); ++k) {
    threads.emplace_back([&ended] {
      for (volatile std::uint64_t sum = 0; !ended;) sum = sum + 1;
    });
  }
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  ended = true;
}

/// Takes 300 MB, touches them and gives them back, over and over for so long.
void takeMemory(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end) {
    std::vector<char> memory(300'000'000);
    for (std::size_t at = 0; at < memory.size(); at += 4096) static_cast<volatile char&>(memory[at]) = 1;
  }
}

/// A servo of its own for each, so that the figures are of this time alone. work: in a thread beside it, until it ends.
template <class Work>
void measure(const char* name, const Work& work) {
  const std::unique_ptr<servo::Host> host = runningHost();
  if (host == nullptr) return;
  std::atomic<bool> ended{false};
  const auto begin = std::chrono::steady_clock::now();
  std::thread worker([&] {
    work();
    ended = true;
  });
  std::int64_t ticks = 0;
  while (!ended) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    host->drain([&](const servo::TickRecord&) { ++ticks; });
  }
  worker.join();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const servo::Percentiles late = host->timing().lateness();
  std::printf("%-34s %7.1f s %8lld ticks %4lld late  lateness us p50 %6.1f p99 %7.1f p99.9 %8.1f max %8.1f\n", name,
              seconds, static_cast<long long>(ticks), static_cast<long long>(host->snapshot().late.total), late.p50_us,
              late.p99_us, late.p999_us, late.max_us);
}

}  // namespace
}  // namespace underact

int main(int count, char** words) {
  using namespace underact;
  if (count > 2 && std::strcmp(words[1], "--take") == 0) return takeMemory(std::atof(words[2])), 0;
  const int seconds = count > 1 ? std::max(1, std::atoi(words[1])) : 10;
  const int faces = count > 2 ? std::max(1000, std::atoi(words[2])) : 2'000'000;
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "underact_large_mesh.ply";
  std::ofstream(file, std::ios::binary) << mesh_maker::asPly(mesh_maker::bumpySphere(faces));
  measure("nothing else", [&] { std::this_thread::sleep_for(std::chrono::seconds(seconds)); });
  double load_s = 0.0;
  measure("loads a mesh, not in the cache", [&] {
    const auto begin = std::chrono::steady_clock::now();
    const auto loaded = mesh_file::loadMesh(file.string(), {}, mesh_file::Cache("/dev/null/nowhere"));
    std::printf("%s\n", loaded ? "loaded" : loaded.problems().at(0).sentence.c_str());
    load_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  });
  measure("threads that only count, as long", [&] { onlyCount(load_s); });
  const std::string other = "'" + std::string(words[0]) + "' --take " + std::to_string(load_s);
  measure("another process takes memory", [&] {
    if (std::system(other.c_str()) != 0) std::printf("it could not be started\n");
  });
  std::filesystem::remove(file);
  return 0;
}
