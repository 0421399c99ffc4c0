// Arguments: --uhid: behind this computer's kernel (it takes /dev/uhid, and makes a HID device there) instead of in the
// place of hidapi; --seconds N.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "core/servo/host.h"
#include "device/catalogue.h"
#include "device/wooden_haptics/wooden_arm.h"
#include "tests/support/hid_double.h"
#include "tests/support/uhid_board.h"

namespace {

using namespace underact;

/// A spring to a point, between two places of the tip 2 mm apart: each step turns the force about.
scene::Description spring() {
  scene::Description scene;
  scene.title = "Spring";
  scene.constraints.push_back({"point", scene::Point{Vec3(0.0, 0.0, 60.0)}, target::Side::Both, {}, {}});
  return scene;
}

void measure(const char* name, const test::WoodenFirmware::Built& built, bool through_kernel, int seconds) {
  test::WoodenFirmware firmware(built);
  test::HidDouble bus(firmware);
  test::UhidBoard board(firmware);
  Result<std::unique_ptr<servo::DevicePort>> arm = Problems{};
  if (through_kernel) {
    board.plugIn();
    arm = device::openDevice("wooden", {*arm::findPreset(arm::kDefaultArm), {}, 1000, ""});
  } else {
    auto opened = device::WoodenArm::open(bus, {}, arm::findPreset(arm::kDefaultArm)->geometry, 1000);
    if (opened) arm = std::unique_ptr<servo::DevicePort>(std::move(opened).value());
  }
  if (!arm) {
    std::printf("%-4s cannot be opened\n", name);
    return;
  }
  servo::Host host(std::move(arm).value(), servo::HostOptions{.max_late = 1'000'000});
  if (!host.load(spring()).empty()) return;
  host.start();
  host.begin();
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  int faults = 0;
  for (int step = 0; std::chrono::steady_clock::now() < end; ++step) {
    firmware.placeTip(Vec3(step % 2 == 0 ? 1e-3 : -1e-3, 0.0, 0.06));
    std::this_thread::sleep_for(std::chrono::microseconds(7'300 + 370 * (step % 3)));  // no multiple of a tick
    host.drain([](const servo::TickRecord&) {});
    if (host.takeFault()) ++faults, host.start();
  }
  std::vector<std::int64_t> all_ns = firmware.reactions_ns();
  if (all_ns.empty()) return;
  std::sort(all_ns.begin(), all_ns.end());
  const auto at_ms = [&](double share) {
    return 1e-6 * static_cast<double>(all_ns[static_cast<std::size_t>(share * static_cast<double>(all_ns.size() - 1))]);
  };
  std::printf("%-4s %7zu %8.3f %8.3f %8.3f %8.3f %8d   %s\n", name, all_ns.size(), at_ms(0.0), at_ms(0.5), at_ms(0.99),
              at_ms(1.0), faults, host.scheduling().name.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  bool through_kernel = false;
  int seconds = 10;
  for (int at = 1; at < argc; ++at) {
    through_kernel |= std::strcmp(argv[at], "--uhid") == 0;
    if (std::strcmp(argv[at], "--seconds") == 0 && at + 1 < argc) seconds = std::atoi(argv[at + 1]);
  }
  std::printf(
      "WoodenHaptics at 1 kHz, from a report of a new place to the currents for it, ms, seen by the board (%s)\n",
      through_kernel ? "behind the kernel" : "in the place of hidapi");
  std::printf("     samples      min   median      99%%      max   faults   servo\n");
  measure("V1", {}, through_kernel, seconds);
  measure("V2", {2, 14, {0.321, 0.0603, 0.0603}}, through_kernel, seconds);
  return 0;
}
