// underact-cli with one kind of arm alone, "wire": an arm with a last word, behind the descriptor that is the first
// argument. The others are the command line's.
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <iostream>

#include "app/cli/command.h"
#include "device/catalogue.h"
#include "tests/process/wire_port.h"

namespace underact::device {
namespace {

int wire_fd = -1;

Result<std::unique_ptr<servo::DevicePort>> openWire(const Request& /*request*/) {
  return std::unique_ptr<servo::DevicePort>(std::make_unique<test::WirePort>(wire_fd));
}
std::vector<Found> searchWire() {
  return {};
}
constexpr std::array kWires{Driver{"wire", "Arm behind a wire", openWire, searchWire}};

}  // namespace

// In the place of device/catalogue.cpp.
std::span<const Driver> catalogue() {
  return kWires;
}
std::string nameOf(const Driver& driver, const Found& /*found*/) {
  return driver.key;
}
const Driver* findDevice(std::string_view /*key*/) {
  return kWires.data();
}
Result<std::unique_ptr<servo::DevicePort>> openDevice(std::string_view /*name*/, Request request) {
  return openWire(request);
}

}  // namespace underact::device

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  underact::device::wire_fd = std::atoi(argv[1]);
  const underact::cli::Streams streams{std::cin, std::cout, std::cerr, false, STDOUT_FILENO};
  return static_cast<int>(underact::cli::execute({argv + 2, argv + argc}, streams));
}
