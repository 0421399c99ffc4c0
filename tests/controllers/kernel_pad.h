#pragma once
#include <umockdev.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace underact::test {

/// One axis as the kernel tells of it: its code (ABS_X is 0, ABS_HAT0X is 16) and its range.
struct KernelAxis {
  int code, min, max;
};

/// What the kernel tells of a device of its own accord.
struct KernelPadKind {
  std::string name;
  std::uint16_t vendor, product;
  std::vector<int> buttons;  // codes: BTN_SOUTH is 0x130
  std::vector<KernelAxis> axes;
};

/// A controller on the USB as programs meet it on Linux: a node of evdev that answers what it is asked, tells events,
/// and goes with the cable. One at a time.
class KernelPad {
 public:
  explicit KernelPad(const KernelPadKind& kind);
  ~KernelPad();
  KernelPad(const KernelPad&) = delete;
  KernelPad& operator=(const KernelPad&) = delete;

  void plugIn();
  void unplug();
  void move(int axis, int value);
  void press(int button, bool down);

 private:
  static gboolean handle(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer pad);  // umockdev's thread
  std::vector<guint8> answer(gulong request) const;
  void tell(int type, int code, int value);
  std::filesystem::path node() const;

  KernelPadKind kind_;
  std::vector<std::atomic<int>> values_;  // of each axis
  UMockdevTestbed* kernel_;
  UMockdevIoctlBase* questions_;
  std::filesystem::path cable_;  // what the node leads to; empty: it was never plugged in
};

}  // namespace underact::test
