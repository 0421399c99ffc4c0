// A program of its own, to which no library of the vendor's is linked: it opens the arm that LD_LIBRARY_PATH leads to,
// lets the servo push for a moment, and says what came of it, a line each.
#include <dlfcn.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "core/arm/preset.h"
#include "core/servo/host.h"
#include "device/catalogue.h"
#include "tests/openhaptics/hd/control.h"

using namespace underact;

namespace {

/// The arm's end of the library that the driver has loaded; it is only looked for, not loaded.
const test::hd::Control* theFarEnd() {
  void* const library = dlopen("libHD.so.3.4", RTLD_NOW | RTLD_NOLOAD);
  if (library == nullptr) return nullptr;
  const auto find = reinterpret_cast<test::hd::FindControl>(dlsym(library, test::hd::kControlName));
  return find != nullptr ? find() : nullptr;
}

double sizeAt(const test::hd::Control& far) {
  Vec3 f_N;
  far.force(f_N.data());
  return f_N.norm();
}

}  // namespace

int main() {
  device::Request request;
  request.arm = *arm::findPreset(arm::kDefaultArm);
  Result<std::unique_ptr<servo::DevicePort>> arm = device::openDevice("openhaptics", request);
  if (!arm) {
    std::printf("%s\n", arm.problems().front().sentence.c_str());
    return 1;
  }
  const test::hd::Control* const far = theFarEnd();
  if (far == nullptr) return 2;
  scene::Description scene;
  scene.title = "Pull";
  scene.constraints.push_back({"point", scene::Point{Vec3(5.0, 0.0, 60.0)}, target::Side::Both, {}, {}});
  double max_N = 0.0;
  {
    servo::Host host(std::move(arm).value(), servo::HostOptions{.max_late = 1'000'000});
    std::printf("%s\n", host.device().title.c_str());
    if (!host.load(scene).empty()) return 3;
    host.start();
    host.begin();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (max_N < 0.3 && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      (void)host.snapshot();
      max_N = sizeAt(*far);
    }
  }
  std::printf("%s\n%s\n", max_N >= 0.3 ? "pushed" : "did not push", sizeAt(*far) == 0.0 ? "rests" : "pushes still");
  std::printf("%s\n", far->isOpen() ? "open" : "closed");
  return 0;
}
