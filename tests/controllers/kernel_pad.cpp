#include "tests/controllers/kernel_pad.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include "tests/support/comes.h"

namespace underact::test {
namespace {

constexpr const char* kNode = "/dev/input/event5";
// As udev would tell of it; umockdev's own format.
constexpr const char* kDevice =
    "P: /devices/virtual/input/input5\nN: input/event5\nE: DEVNAME=/dev/input/event5\nE: MAJOR=13\nE: MINOR=69\n"
    "E: SUBSYSTEM=input\nA: dev=13:69\\n\n";

using Bytes = std::vector<guint8>;

Bytes bits(const std::vector<int>& codes, std::size_t size) {
  Bytes bytes(size);
  for (const int code : codes) {
    guint8& byte = bytes.at(static_cast<std::size_t>(code) / 8);
    byte = static_cast<guint8>(byte | 1U << (static_cast<unsigned>(code) % 8));
  }
  return bytes;
}

template <class Value>
Bytes bytesOf(const Value& value) {
  Bytes bytes(sizeof value);
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

bool answers() {
  const int node = open(kNode, O_RDONLY | O_CLOEXEC);
  input_id id{};
  const bool does = ioctl(node, EVIOCGID, &id) >= 0;
  close(node);
  return does;
}

}  // namespace

KernelPad::KernelPad(const KernelPadKind& kind)
    : kind_(kind), values_(kind.axes.size()), kernel_(umockdev_testbed_new()), questions_(umockdev_ioctl_base_new()) {
  g_signal_connect(questions_, "handle-ioctl", G_CALLBACK(&KernelPad::handle), this);
}

KernelPad::~KernelPad() {
  if (!cable_.empty()) umockdev_testbed_detach_ioctl(kernel_, kNode, nullptr);
  g_object_unref(kernel_);
  g_object_unref(questions_);
}

void KernelPad::plugIn() {
  if (!cable_.empty()) return std::filesystem::create_symlink(cable_, node());
  EXPECT_TRUE(umockdev_testbed_attach_ioctl(kernel_, kNode, questions_, nullptr));
  EXPECT_TRUE(umockdev_testbed_add_from_string(kernel_, kDevice, nullptr));
  cable_ = std::filesystem::read_symlink(node());
  // The node is a terminal, which would take the 3 of an axis' event for Ctrl+C.
  termios raw{};
  EXPECT_EQ(tcgetattr(umockdev_testbed_get_dev_fd(kernel_, kNode), &raw), 0);
  cfmakeraw(&raw);
  EXPECT_EQ(tcsetattr(umockdev_testbed_get_dev_fd(kernel_, kNode), TCSANOW, &raw), 0);
  EXPECT_TRUE(comes(&answers));  // umockdev begins to listen a moment later
}

// umockdev cannot bring a device back that it removed: only its node goes.
void KernelPad::unplug() {
  std::filesystem::remove(node());
}

void KernelPad::move(int axis, int value) {
  for (std::size_t number = 0; number < values_.size(); ++number) {
    if (kind_.axes[number].code == axis) values_[number] = value;
  }
  tell(EV_ABS, axis, value);
}

void KernelPad::press(int button, bool down) {
  tell(EV_KEY, button, down ? 1 : 0);
}

void KernelPad::tell(int type, int code, int value) {
  const int node = umockdev_testbed_get_dev_fd(kernel_, kNode);
  for (const auto& [kind, what, state] : {std::array{type, code, value}, std::array{EV_SYN, SYN_REPORT, 0}}) {
    input_event event{};
    event.type = static_cast<std::uint16_t>(kind);
    event.code = static_cast<std::uint16_t>(what);
    event.value = state;
    EXPECT_EQ(write(node, &event, sizeof event), static_cast<ssize_t>(sizeof event));
  }
}

std::filesystem::path KernelPad::node() const {
  const std::unique_ptr<char, decltype(&g_free)> root(umockdev_testbed_get_root_dir(kernel_), &g_free);
  return std::string(root.get()) + kNode;
}

std::vector<guint8> KernelPad::answer(gulong request) const {
  const unsigned number = _IOC_NR(request);
  const std::size_t room = _IOC_SIZE(request);
  if (number == _IOC_NR(EVIOCGBIT(0, 0))) return bits({EV_SYN, EV_KEY, EV_ABS}, room);
  if (number == _IOC_NR(EVIOCGBIT(EV_KEY, 0))) return bits(kind_.buttons, room);
  if (number == _IOC_NR(EVIOCGID)) return bytesOf(input_id{BUS_USB, kind_.vendor, kind_.product, 0x110});
  if (number == _IOC_NR(EVIOCGNAME(0))) return {kind_.name.c_str(), kind_.name.c_str() + kind_.name.size() + 1};
  std::vector<int> codes;
  for (std::size_t axis = 0; axis < values_.size(); ++axis) {
    const auto& [code, min, max] = kind_.axes[axis];
    if (number == _IOC_NR(EVIOCGABS(code))) return bytesOf(input_absinfo{values_[axis], min, max, 0, 0, 0});
    codes.push_back(code);
  }
  return number == _IOC_NR(EVIOCGBIT(EV_ABS, 0)) ? bits(codes, room) : Bytes{};
}

gboolean KernelPad::handle(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer pad) {
  const gulong request = umockdev_ioctl_client_get_request(client);
  Bytes bytes = static_cast<const KernelPad*>(pad)->answer(request);
  if (bytes.empty() || bytes.size() > _IOC_SIZE(request)) {
    umockdev_ioctl_client_complete(client, -1, EINVAL);
    return TRUE;
  }
  UMockdevIoctlData* const room =
      umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, _IOC_SIZE(request), nullptr);
  umockdev_ioctl_data_update(room, 0, bytes.data(), static_cast<gint>(bytes.size()));
  umockdev_ioctl_data_unref(room);
  umockdev_ioctl_client_complete(client, static_cast<glong>(bytes.size()), 0);
  return TRUE;
}

}  // namespace underact::test
