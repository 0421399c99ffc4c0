#include <hidapi/hidapi.h>

#include <array>
#include <cstdio>
#include <mutex>

#include "core/base/translate.h"
#include "core/system/file.h"
#include "device/wooden_haptics/hid_bus.h"

namespace underact::device {
namespace {

/// hidapi stores the error of listing and opening in one place for all threads.
std::mutex& hidapiMutex() {
  static std::mutex mutex;
  return mutex;
}

std::string narrow(const wchar_t* text) {
  std::string narrowed;
  for (; text != nullptr && *text != L'\0'; ++text) narrowed += *text < 0x7F ? static_cast<char>(*text) : '?';
  return narrowed;
}

class HidapiPipe final : public HidPipe {
 public:
  // Opened twice: a device stores the text of its last error, which read and write both free, so a handle shared by two
  // threads would be freed twice when the cable is pulled.
  explicit HidapiPipe(const std::string& path)
      : reads_(::hid_open_path(path.c_str())),
        writes_(::hid_open_path(path.c_str())),
        for_guard_(system::openToWrite(path)),
        // Two programs that drive one arm push twice as hard as either allows: one program at a time, and one instance
        // in it.
        is_taken_(for_guard_.isOpen() && !system::lock(for_guard_.number(), system::Lock::Alone)) {}
  ~HidapiPipe() override {
    const std::scoped_lock lock(hidapiMutex());
    if (reads_ != nullptr) ::hid_close(reads_);
    if (writes_ != nullptr) ::hid_close(writes_);
  }
  bool isOpen() const { return reads_ != nullptr && writes_ != nullptr; }
  bool isTaken() const { return is_taken_; }

  int read(std::span<std::uint8_t> report, int time_ms) override {
    return ::hid_read_timeout(reads_, report.data(), report.size(), time_ms);
  }
  bool write(std::span<const std::uint8_t> report) override {
    return ::hid_write(writes_, report.data(), report.size()) >= 0;
  }
  int guardFd() const override { return for_guard_.number(); }

 private:
  hid_device* reads_;
  hid_device* writes_;
  system::Descriptor for_guard_;
  bool is_taken_;
};

class HidapiBus final : public HidBus {
 public:
  std::vector<HidNode> nodes() override {
    const std::scoped_lock lock(hidapiMutex());
    std::vector<HidNode> found;
    hid_device_info* const all = ::hid_enumerate(0, 0);
    for (const hid_device_info* one = all; one != nullptr; one = one->next) {
      if (one->path == nullptr) continue;
      found.push_back(
          {one->vendor_id, one->product_id, one->usage_page, one->usage, one->path, narrow(one->serial_number)});
    }
    ::hid_free_enumeration(all);
    return found;
  }

  Result<std::unique_ptr<HidPipe>> open(const HidNode& node) override {
    std::unique_ptr<HidapiPipe> pipe;  // its destructor takes the same lock
    {
      const std::scoped_lock lock(hidapiMutex());
      pipe = std::make_unique<HidapiPipe>(node.path);
    }
    if (pipe->isTaken())
      return Problems{
          {phrase(TRANSLATE_NOOP("problem", "%1 is already in use, here or by another program of this kind."),
                  {node.path}),
           {}}};
    if (pipe->isOpen()) return std::unique_ptr<HidPipe>(std::move(pipe));
    if (!mayOpen(node))
      return Problems{
          {phrase(TRANSLATE_NOOP("problem",
                                 "You do not have permission to open %1. This command, in a terminal, grants it: %2"),
                  {node.path, udevCommand(node)}),
           {}}};
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "%1 cannot be opened. Unplug it and plug it in again."), {node.path}), {}}};
  }

  bool mayOpen(const HidNode& node) const override { return system::mayReadAndWrite(node.path); }
};

}  // namespace

std::string udevCommand(const HidNode& node) {
  std::array<char, 16> vendor{}, product{};
  std::snprintf(vendor.data(), vendor.size(), "%04x", node.vendor);
  std::snprintf(product.data(), product.size(), "%04x", node.product);
  const std::string v(vendor.data()), p(product.data());
  // Before 73-seat-late.rules, which is what heeds uaccess.
  return "echo 'KERNEL==\"hidraw*\", ATTRS{idVendor}==\"" + v + "\", ATTRS{idProduct}==\"" + p +
         "\", TAG+=\"uaccess\"' | sudo tee /etc/udev/rules.d/70-underact-" + v + "-" + p +
         ".rules && sudo udevadm control --reload && sudo udevadm trigger";
}

HidBus& hidapiBus() {
  static HidapiBus bus;
  return bus;
}

}  // namespace underact::device
