#include "tests/contract/drivers.h"

#include <cstdlib>

namespace underact::test {

std::vector<Driver> drivers() {
  std::vector<Driver> all;
  all.push_back({"simulated", simulatedFarSide});
  all.push_back({"replayed", replayedFarSide});
  all.push_back({"openhaptics", openHapticsFarSide});
  all.push_back({"wooden_v1", woodenV1FarSide});
  all.push_back({"wooden_v2", woodenV2FarSide});
  all.push_back({"wooden_teensy", woodenTeensyFarSide});
  all.push_back({"remote", remoteFarSide});
  all.push_back({"haply", haplyFarSide});
  all.push_back({"haply_v31", haplyOldFarSide});
  // Only where it was asked for, as tests/vm/run does: nobody's own computer is to see a device that is none.
  if (std::getenv("UNDERACT_UHID") != nullptr) {
    all.push_back({"wooden_uhid_v1", woodenUhidV1FarSide});
    all.push_back({"wooden_uhid_v2", woodenUhidV2FarSide});
  }
  return all;
}

}  // namespace underact::test
