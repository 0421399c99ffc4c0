// Arguments: --seconds N (10, of each row).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "core/servo/host.h"
#include "tests/support/shared_arm.h"

namespace {

using namespace underact;

/// A spring to a point, between two places of the tip 0.4 mm apart: each step turns the force about.
scene::Description spring() {
  scene::Description scene;
  scene.title = "Spring";
  scene.constraints.push_back({"point", scene::Point{Vec3(0.0, 0.0, 60.0)}, target::Side::Both, {}, {}});
  return scene;
}

void measure(const char* name, test::ArmDouble& arm, std::unique_ptr<servo::DevicePort> port, int seconds) {
  servo::Host host(std::move(port), servo::HostOptions{.max_late = 1'000'000});
  if (!host.load(spring()).empty()) return;
  host.start();
  host.begin();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // the soft start
  std::vector<std::int64_t> all_ns;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  int faults = 0, none = 0;
  for (int step = 0; std::chrono::steady_clock::now() < end; ++step) {
    arm.placeTip(Vec3(step % 2 == 0 ? 2e-4 : -2e-4, 0.0, 0.06));
    std::this_thread::sleep_for(std::chrono::microseconds(13'300 + 370 * (step % 3)));  // no multiple of a tick
    host.drain([](const servo::TickRecord&) {});
    const std::int64_t answered_ns = arm.answered_ns();
    if (answered_ns > 0) all_ns.push_back(answered_ns);
    if (answered_ns == 0) ++none;
    if (host.takeFault()) ++faults, host.start();
  }
  if (all_ns.empty()) return;
  std::sort(all_ns.begin(), all_ns.end());
  const auto at_ms = [&](double share) {
    return 1e-6 * static_cast<double>(all_ns[static_cast<std::size_t>(share * static_cast<double>(all_ns.size() - 1))]);
  };
  std::printf("%-14s %7zu %8.3f %8.3f %8.3f %8.3f %11d %8d   %s\n", name, all_ns.size(), at_ms(0.0), at_ms(0.5),
              at_ms(0.99), at_ms(1.0), none, faults, host.scheduling().name.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  int seconds = 10;
  for (int at = 1; at + 1 < argc; ++at) {
    if (std::strcmp(argv[at], "--seconds") == 0) seconds = std::atoi(argv[at + 1]);
  }
  std::printf("An arm at 1 kHz, from the sample of a new place to the force for it, ms, seen by the arm\n");
  std::printf("               samples      min   median      99%%      max   in no time   faults   servo\n");
  test::ArmDouble arm;
  measure("here", arm, std::make_unique<test::ArmDouble::Port>(arm), seconds);
  for (const double delay_ms : {-1.0, 0.0, 5.0}) {
    test::SharedArm shared(true, false);
    if (delay_ms >= 0.0) shared.cable().delay(delay_ms, 0.0);
    auto opened = shared.open(nullptr, 1000, delay_ms < 0.0);
    if (!opened) {
      std::printf("%s\n", opened.problems().front().sentence.c_str());
      continue;
    }
    const char* const name = delay_ms < 0.0 ? "remote" : delay_ms == 0.0 ? "over a relay" : "5 ms each way";
    measure(name, shared.arm, std::move(opened).value(), seconds);
  }
  return 0;
}
