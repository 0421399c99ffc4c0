#include "tests/support/uhid_board.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace underact::test {
namespace {

constexpr std::int64_t kFrame_ns = 1'000'000;
constexpr const char* kId = "HID_ID=0003:00001234:00000006";  // bus USB

std::int64_t now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

/// Vendor page 0xFFAB, usage 0x0200; reports of so many bytes both ways, without ids.
std::vector<std::uint8_t> descriptor(std::size_t bytes) {
  const auto count = static_cast<std::uint8_t>(bytes);
  return {0x06, 0xAB, 0xFF,  0x0A, 0x00, 0x02, 0xA1, 0x01, 0x75,  0x08, 0x15, 0x00, 0x26, 0xFF,
          0x00, 0x95, count, 0x09, 0x01, 0x81, 0x02, 0x95, count, 0x09, 0x02, 0x91, 0x02, 0xC0};
}

}  // namespace

UhidBoard::UhidBoard(WoodenFirmware& firmware) : firmware_(firmware) {}

UhidBoard::~UhidBoard() {
  unplug();
}

bool UhidBoard::isPossible() {
  const int fd = ::open("/dev/uhid", O_RDWR | O_CLOEXEC);
  if (fd >= 0) ::close(fd);
  return fd >= 0;
}

void UhidBoard::create() const {
  uhid_event event{};
  event.type = UHID_CREATE2;
  uhid_create2_req& made = event.u.create2;
  std::strcpy(reinterpret_cast<char*>(made.name), "mbed HID DEVICE");
  std::strcpy(reinterpret_cast<char*>(made.uniq), "0042");
  const std::vector<std::uint8_t> description = descriptor(firmware_.reportBytes());
  made.rd_size = static_cast<std::uint16_t>(description.size());
  std::memcpy(made.rd_data, description.data(), description.size());
  made.bus = 3;  // BUS_USB
  made.vendor = 0x1234;
  made.product = 0x0006;
  EXPECT_EQ(::write(fd_, &event, sizeof event), static_cast<ssize_t>(sizeof event));
}

void UhidBoard::plugIn() {
  fd_ = ::open("/dev/uhid", O_RDWR | O_CLOEXEC);
  ASSERT_GE(fd_, 0);
  create();
  ends_ = false;
  is_asked_ = false;
  thread_ = std::thread(&UhidBoard::run, this);
  for (int wait = 0; wait < 500 && node().empty(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

void UhidBoard::unplug() {
  if (fd_ < 0) return;
  ends_ = true;
  thread_.join();
  ::close(fd_);  // and with it the device
  fd_ = -1;
  for (int wait = 0; wait < 500 && !node().empty(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

std::string UhidBoard::node() const {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/sys/class/hidraw", error)) {
    std::ifstream file(entry.path() / "device/uevent");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string path = "/dev/" + entry.path().filename().string();
    if (text.find(kId) != std::string::npos && ::access(path.c_str(), F_OK) == 0) return path;
  }
  return {};
}

void UhidBoard::run() {
  while (!ends_) {
    const bool talks = !firmware_.onlyAnswers() || is_asked_;
    const std::int64_t left_ns = talks ? next_ns_ - now_ns() : 5 * kFrame_ns;
    pollfd ready{fd_, POLLIN, 0};
    const timespec wait{0, static_cast<long>(left_ns > 0 ? left_ns : 0)};
    if (::ppoll(&ready, 1, &wait, nullptr) > 0) hear();
    if ((!firmware_.onlyAnswers() || is_asked_) && now_ns() >= next_ns_) {
      say();
      is_asked_ = false;
      next_ns_ = now_ns() + kFrame_ns;
    }
  }
}

void UhidBoard::say() const {
  const std::vector<std::uint8_t> report = firmware_.report(now_ns());
  uhid_event event{};
  event.type = UHID_INPUT2;
  event.u.input2.size = static_cast<std::uint16_t>(report.size());
  std::memcpy(event.u.input2.data, report.data(), report.size());
  [[maybe_unused]] const ssize_t written = ::write(fd_, &event, sizeof event);  // refused until the kernel is ready
}

void UhidBoard::hear() {
  uhid_event event{};
  if (::read(fd_, &event, sizeof event) <= 0 || event.type != UHID_OUTPUT) return;
  // The kernel's USB driver takes the report id 0 off; this border gets it.
  const std::size_t size = event.u.output.size;
  if (size < 1 || event.u.output.data[0] != 0) return;
  firmware_.receive({event.u.output.data + 1, size - 1}, now_ns());
  if (!is_asked_ && firmware_.onlyAnswers()) next_ns_ = now_ns() + kFrame_ns;
  is_asked_ = true;
}

}  // namespace underact::test
