// The servo at work on an arm behind a wire, until it dies. Arguments: the wire's descriptor, the guard, the way to
// die: "abort", "segv", "exit", "return", "wait" to be killed, or "go on" likewise, with the force started again
// after each fault that a busy machine explains.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>

#include "core/servo/host.h"
#include "tests/process/wire_port.h"

namespace underact {
namespace {

volatile std::sig_atomic_t is_asked_to_end = 0;

/// Where the arm stands (see process_test.cpp) it is pressed with some 0.4 N.
scene::Description ball() {
  scene::Description scene;
  scene.title = "Ball";
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 50.8}, target::Side::Both, {}, {}});
  return scene;
}

void say(const std::string& word) {
  std::printf("%s\n", word.c_str());
  std::fflush(stdout);
}

/// A busy machine does these to a program that is well; they end the force until somebody starts it again.
bool isOfBusyMachine(FaultKind kind) {
  return kind == FaultKind::NoSample || kind == FaultKind::TooLate || kind == FaultKind::StoodStill;
}

/// A word on standard output for everything that happens: the test listens there.
void follow(servo::Host& host, const std::string& ending) {
  bool told = false, guarded = true;
  for (;;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    host.drain([](const servo::TickRecord&) {});
    const servo::Snapshot snapshot = host.snapshot();
    if (const auto fault = host.takeFault()) {
      if (!told || (ending == "go on" && isOfBusyMachine(fault->fault.kind))) host.start();
      if (told) say(std::string("fault ") + name(fault->fault.kind));
    }
    if (const bool is_guarded = host.unguarded().empty(); told && std::exchange(guarded, is_guarded) != is_guarded)
      say(is_guarded ? host.guarding() : host.unguarded());
    if (told && is_asked_to_end != 0) return;
    if (snapshot.report.level < 1.0 || told) continue;
    told = true;
    guarded = host.unguarded().empty();
    say("pushing");
    if (ending == "abort") std::abort();
    if (ending == "segv") std::raise(SIGSEGV);
    if (ending == "exit") std::_Exit(3);
    if (ending == "return") return;
  }
}

}  // namespace
}  // namespace underact

int main(int argc, char** argv) {
  using namespace underact;
  if (argc != 4) return 2;
  std::signal(SIGUSR1, [](int) { is_asked_to_end = 1; });
  servo::HostOptions options;
  options.guard_program = argv[2];
  servo::Host host(std::make_unique<test::WirePort>(std::atoi(argv[1])), options);
  if (!host.load(ball()).empty()) return 2;
  host.start();
  host.begin();
  follow(host, argv[3]);
  return 0;
}
