#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace underact::device {

/// A HID device that is plugged in.
struct HidNode {
  std::uint16_t vendor = 0, product = 0;
  std::uint16_t usage_page = 0, usage = 0;  // 0: not known, while it may not be opened
  std::string path;                         // "/dev/hidraw3"
  std::string serial;                       // empty: none
};

/// An open device. Two threads: one reads, one writes. Destruction closes it.
class HidPipe {
 public:
  virtual ~HidPipe() = default;
  /// The next report: its number of bytes; 0: none came in time_ms; below 0: the device is gone.
  virtual int read(std::span<std::uint8_t> report, int time_ms) = 0;
  /// A report, its id first. May take some 10 ms. false: the device is gone, or did not accept it.
  virtual bool write(std::span<const std::uint8_t> report) = 0;
  /// Another descriptor of the same device, for a guard; below 0: there is none.
  virtual int guardFd() const { return -1; }
};

/// All HID devices of a computer. Not in the tick.
class HidBus {
 public:
  virtual ~HidBus() = default;
  virtual std::vector<HidNode> nodes() = 0;
  /// Problems: why it cannot be opened, with the way out.
  virtual Result<std::unique_ptr<HidPipe>> open(const HidNode& node) = 0;
  /// Whether this user may open it.
  virtual bool mayOpen(const HidNode& node) const = 0;
};

/// This computer's, by hidapi.
HidBus& hidapiBus();

/// The command that lets a user who sits at the computer open a HID device.
std::string udevCommand(const HidNode& node);

}  // namespace underact::device
