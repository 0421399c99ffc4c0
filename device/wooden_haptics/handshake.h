#pragma once
#include <memory>
#include <string>

#include "device/wooden_haptics/hid_bus.h"
#include "device/wooden_haptics/models.h"

namespace underact::device {

/// Which arm is meant. "MODEL/WHICH", either may be missing: "woody-2019", "0042", "woody-2019//dev/hidraw3".
struct WoodenChoice {
  const WoodenModel* model = nullptr;  // null: the default of its protocol
  std::string which = {};              // serial number or path; empty: the first
};
WoodenChoice readWoodenAddress(const std::string& address);

/// The devices that are such an arm, or may be one: see WoodenId::is_shared.
std::vector<HidNode> woodenNodes(HidBus& bus);

/// A connection to an arm that has answered.
struct WoodenLine {
  HidNode node;
  std::unique_ptr<HidPipe> pipe;
  WoodenFormat format;
  const WoodenModel* model = nullptr;
  WoodenReport first;
};

/// Finds the arm (a board that may be anything only if it is asked for by name), opens it and learns its protocol from
/// the length of its first report: V1 reports by itself, V2 only after it was sent zero. Takes up to a second.
/// Problems: none is plugged in; it may not be opened; it sends nothing known; the kinematics of its model are not
/// published.
Result<WoodenLine> shakeHands(HidBus& bus, const WoodenChoice& choice);

}  // namespace underact::device
