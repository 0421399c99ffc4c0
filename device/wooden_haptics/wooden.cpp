#include "device/wooden_haptics/wooden.h"

#include <algorithm>

#include "core/base/translate.h"
#include "device/wooden_haptics/wooden_arm.h"

namespace underact::device {

Result<std::unique_ptr<servo::DevicePort>> openWooden(const Request& request) {
  Result<std::unique_ptr<WoodenArm>> arm =
      WoodenArm::open(hidapiBus(), readWoodenAddress(request.address), request.arm.geometry, request.rate_hz);
  if (!arm) return arm.problems();
  return std::unique_ptr<servo::DevicePort>(std::move(arm).value());
}

std::vector<Found> searchWooden() {
  return searchWooden(hidapiBus());
}

std::vector<Found> searchWooden(HidBus& bus) {
  const std::vector<HidNode> nodes = woodenNodes(bus);
  std::vector<Found> found;
  for (const HidNode& node : nodes) {
    const WoodenId& id = *findWoodenId(node.vendor, node.product);
    // Boards that were given no serial number of their own all have the same one.
    const auto alike =
        std::count_if(nodes.begin(), nodes.end(), [&](const HidNode& other) { return other.serial == node.serial; });
    const bool has_serial = !node.serial.empty() && alike == 1;
    Found one{id.board, has_serial ? node.serial : node.path, {}};
    one.title = has_serial ? phrase(TRANSLATE_NOOP("problem", "%1, serial %2"), {id.board, one.address})
                           : Sentence(id.board + (", " + one.address));
    if (id.is_shared) one.title = phrase(TRANSLATE_NOOP("problem", "%1: perhaps a WoodenHaptics arm"), {one.title});
    if (!bus.mayOpen(node))
      one.missing.push_back(
          {phrase(TRANSLATE_NOOP("problem",
                                 "You do not have permission to open %1: the system's rules give it to nobody."),
                  {node.path}),
           udevCommand(node)});
    found.push_back(std::move(one));
  }
  return found;
}

}  // namespace underact::device
