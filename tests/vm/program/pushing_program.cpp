// The servo at work on an arm that stands behind the kernel, until somebody ends it. Arguments: the arm as --device
// takes it, the guard ("" for none).
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include "core/servo/host.h"
#include "device/catalogue.h"

int main(int argc, char** argv) {
  using namespace underact;
  if (argc != 3) return 2;
  device::Request request;
  request.arm = *arm::findPreset(arm::kDefaultArm);
  Result<std::unique_ptr<servo::DevicePort>> arm = device::openDevice(argv[1], request);
  if (!arm) {
    std::printf("%s\n", arm.problems().front().sentence.c_str());
    return 2;
  }
  scene::Description scene;  // some 0.5 N along x where the tip rests
  scene.title = "Pull";
  scene.constraints.push_back({"point", scene::Point{Vec3(5.0, 0.0, 60.0)}, target::Side::Both, {}, {}});
  servo::HostOptions options{.max_late = 1'000'000};
  options.guard_program = *argv[2] != '\0' ? argv[2] : "/there/is/none";
  servo::Host host(std::move(arm).value(), options);
  if (!host.load(scene).empty()) return 2;
  host.start();
  host.begin();
  for (bool told = false;;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    host.drain([](const servo::TickRecord&) {});
    if (host.takeFault()) host.start();  // a busy machine: not what is looked for
    if (told || host.snapshot().report.force.f_T_W().norm() < 0.2) continue;
    told = true;
    std::printf("pushing\n");
    std::fflush(stdout);
  }
}
