#include "tests/session/rig.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

#include "core/scene/compile.h"
#include "core/scene/edit.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/sim/arm_model.h"
#include "core/sim/hand_script.h"
#include "device/simulated_arm.h"

namespace underact::test {

std::vector<std::string> shippedScenes() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(UNDERACT_SOURCE) + "/scenes")) {
    const std::string path = entry.path().string();
    if (path.ends_with(".json") && !path.ends_with("schema.json")) paths.push_back(path);
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

scene::Description sceneAt(const std::string& path) {
  scene::Description scene = scene::readSceneFile(path).value();
  (void)scene::loadMeshes(scene);  // what is missing, the Host says
  return scene;
}

scene::Description sphereScene() {
  scene::Description scene;
  scene.title = "Ball";
  scene.constraints.push_back({"ball", scene::Sphere{Vec3(0.0, 0.0, 20.0), 40.0}, target::Side::Both, {}, {}});
  return scene;
}

tick::TickProgram programOf(const scene::Description& scene) {
  return scene::compile(scene).value();
}

std::unique_ptr<servo::Host> makeHost(servo::Clock clock, const std::string& hand, int rate_hz, std::uint64_t seed) {
  const sim::HandScript script = sim::builtInHand(hand, seed).value();
  device::SimulatedArm::Options options;
  options.arm = *arm::findPreset(arm::kDefaultArm);
  options.model = *sim::findArmModel(sim::kDefaultArmModel);
  options.hand = script.hand;
  options.rate_hz = rate_hz;
  auto arm = std::make_unique<device::SimulatedArm>(options);
  arm->follow(script);
  return std::make_unique<servo::Host>(std::move(arm), servo::HostOptions{.rate_hz = rate_hz, .clock = clock});
}

namespace {

void editSomething(servo::Host& host, Random& random) {
  scene::Description scene = host.scene();
  const std::size_t index = random.below(scene.constraints.size());
  scene::Control control = scene::controlOf(scene, index);
  switch (random.below(3)) {
    case 0:
      control.gains.kp_N_per_mm *= random.between(0.5, 1.5);
      scene = scene::withControl(scene, index, control);
      break;
    case 1:
      if (auto* sphere = std::get_if<scene::Sphere>(&scene.constraints[index].shape)) sphere->radius_mm *= 1.05;
      if (auto* point = std::get_if<scene::Point>(&scene.constraints[index].shape)) point->position_mm.x() += 1.0;
      break;
    default:
      if (scene.constraints[index].influence) scene.constraints[index].influence->t = random.between(0.0, 1.0);
      break;
  }
  EXPECT_TRUE(host.edit(scene).empty()) << scene.title;
}

}  // namespace

void recordEvents(const std::string& path, const scene::Description& scene, const std::string& hand, Seed seed) {
  Random random(seed);
  const std::unique_ptr<servo::Host> host = makeHost(servo::Clock::Manual, hand, 1000, seed.value);
  ASSERT_TRUE(host->load(scene).empty());
  host->start();
  host->run(700 + static_cast<std::int64_t>(random.below(800)));  // the recording begins in the midst
  const auto recorder =
      record::Recorder::start(*host, path, {.name = scene.title}, {.existing = system::Existing::Replace});
  ASSERT_TRUE(recorder) << recorder.problems().front().sentence;
  for (int event = 0; event < 12; ++event) {
    host->run(20 + static_cast<std::int64_t>(random.below(200)));
    switch (random.below(8)) {
      case 0:
        host->stop();
        break;
      case 1:
        ASSERT_TRUE(host->load(event % 2 == 0 ? scene : sphereScene()).empty());
        break;
      case 2:
        recorder.value()->mark("event " + std::to_string(event));
        break;
      default:
        host->start();
        editSomething(*host, random);
        if (random.below(2) == 0) editSomething(*host, random);  // two before one tick
        break;
    }
  }
  recorder.value()->mark("end");
  host->run(150);
  const Problems problems = recorder.value()->stop();
  EXPECT_TRUE(problems.empty()) << problems.front().sentence;
}

}  // namespace underact::test

#if defined(__SANITIZE_ADDRESS__)
/// HDF5 1.10 keeps some memory where it refuses to open a damaged file; what is ours is looked at as ever.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libhdf5_serial";
}
#endif
