// A 3D mouse behind the kernel's HID: hidapi, /dev/hidraw, and what the kernel makes of its descriptor. Run in the
// virtual machine only: see run.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/uhid.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <vector>

#include "device/input/space_mice.h"
#include "device/wooden_haptics/hid_bus.h"
#include "tests/support/comes.h"

namespace underact::test {
namespace {

namespace input = device::input;

/// As a SpaceNavigator describes itself: page 1, usage 8; reports 1 and 2 of three numbers each, 3 of two buttons.
const std::vector<std::uint8_t> kDescriptor{
    0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0xA1, 0x00, 0x85, 0x01, 0x16, 0xA2, 0xFE, 0x26, 0x5E, 0x01, 0x36,
    0x88, 0xFA, 0x46, 0x78, 0x05, 0x75, 0x10, 0x95, 0x03, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x81, 0x02,
    0xC0, 0xA1, 0x00, 0x85, 0x02, 0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x75, 0x10, 0x95, 0x03, 0x81, 0x02,
    0xC0, 0xA1, 0x02, 0x85, 0x03, 0x05, 0x09, 0x19, 0x01, 0x29, 0x02, 0x15, 0x00, 0x25, 0x01, 0x35, 0x00,
    0x45, 0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02, 0x95, 0x0E, 0x81, 0x03, 0xC0, 0xC0};

class UhidSpaceMouse {
 public:
  UhidSpaceMouse() : fd_(::open("/dev/uhid", O_RDWR | O_CLOEXEC)) {
    uhid_event event{};
    event.type = UHID_CREATE2;
    uhid_create2_req& made = event.u.create2;
    std::strcpy(reinterpret_cast<char*>(made.name), "3Dconnexion SpaceNavigator");
    made.rd_size = static_cast<std::uint16_t>(kDescriptor.size());
    std::memcpy(made.rd_data, kDescriptor.data(), kDescriptor.size());
    made.bus = 3;  // BUS_USB
    made.vendor = 0x046D;
    made.product = 0xC626;
    EXPECT_EQ(::write(fd_, &event, sizeof event), static_cast<ssize_t>(sizeof event));
  }
  ~UhidSpaceMouse() { ::close(fd_); }  // and with it the device
  UhidSpaceMouse(const UhidSpaceMouse&) = delete;
  UhidSpaceMouse& operator=(const UhidSpaceMouse&) = delete;
  void say(const std::vector<std::uint8_t>& report) const {
    uhid_event event{};
    event.type = UHID_INPUT2;
    event.u.input2.size = static_cast<std::uint16_t>(report.size());
    std::memcpy(event.u.input2.data, report.data(), report.size());
    [[maybe_unused]] const ssize_t written = ::write(fd_, &event, sizeof event);  // refused until the kernel is ready
  }

 private:
  int fd_;
};

TEST(SpaceMouseInTheMachine, IsFoundReadAndMissedWhenItGoes) {
  const char* const asked = std::getenv("UNDERACT_UHID");
  if (asked == nullptr || *asked != '1') GTEST_SKIP() << "tests/vm/run does this in a virtual machine";
  input::SpaceMice mice(device::hidapiBus(), 50'000'000);
  EXPECT_TRUE(mice.poll().empty());
  {
    const UhidSpaceMouse mouse;
    ASSERT_TRUE(comes([&] { return !mice.poll().empty(); }));
    EXPECT_EQ(mice.poll()[0].name, "SpaceNavigator");
    EXPECT_TRUE(mice.poll()[0].missing.empty());
    const auto readings = [&] { return mice.poll()[0].readings; };
    EXPECT_TRUE(comes([&] {  // again and again, as the mouse itself does
      mouse.say({1, 0x5E, 0x01, 0x51, 0xFF, 0x00, 0x00});
      mouse.say({2, 0x00, 0x00, 0x00, 0x00, 0x23, 0x00});
      const input::Readings now = readings();
      return now.axis[0] == 1.0 && now.axis[1] == -0.5 && now.axis[5] == 0.1;
    }));
    EXPECT_TRUE(comes([&] { return readings().axis[0] == 0.0; }));  // silent: at rest
    EXPECT_TRUE(comes([&] {
      mouse.say({3, 0x02, 0x00});
      return readings().isPressed(1) && !readings().isPressed(0);
    }));
  }
  EXPECT_TRUE(comes([&] { return mice.poll().empty(); }));
}

}  // namespace
}  // namespace underact::test
