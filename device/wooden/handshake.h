#pragma once
#include <memory>
#include <string>

#include "device/wooden/hid_bus.h"
#include "device/wooden/models.h"

namespace underact::device {

/// Which arm is meant. "MODEL/WHICH", either may be missing: "woody-2019", "0042", "woody-2019//dev/hidraw3".
struct WoodenChoice {
  const WoodenModel* model = nullptr;  // null: the default of its protocol
  std::string which = {};              // serial number or path; empty: the first
};
WoodenChoice readWoodenAddress(const std::string& address);

/// The devices that are such an arm, or may be one: see WoodenId::is_shared.
std::vector<HidNode> woodenNodes(HidBus& bus);

/// A line to an arm that has answered.
struct WoodenLine {
  HidNode node;
  std::unique_ptr<HidPipe> pipe;
  WoodenFormat format;
  const WoodenModel* model = nullptr;
  WoodenReport first;
};

/// Finds the arm (a board that may be anything only where it is asked for by name), opens it and learns from the length
/// of its first report what it speaks: V1 talks by itself, V2 only when it has been told zero. Takes up to a second.
/// Problems: none is plugged in; it may not be opened; it says nothing that is known; how its model moves is not
/// published.
Result<WoodenLine> shakeHands(HidBus& bus, const WoodenChoice& choice);

}  // namespace underact::device
