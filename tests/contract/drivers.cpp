#include "tests/contract/drivers.h"

namespace underact::test {

std::vector<Driver> drivers() {
  std::vector<Driver> all;
  all.push_back({"simulated", simulatedFarSide});
  all.push_back({"replayed", replayedFarSide});
  all.push_back({"wooden_v1", woodenV1FarSide});
  all.push_back({"wooden_v2", woodenV2FarSide});
  all.push_back({"wooden_teensy", woodenTeensyFarSide});
  all.push_back({"wooden_uhid_v1", woodenUhidV1FarSide});
  all.push_back({"wooden_uhid_v2", woodenUhidV2FarSide});
  return all;
}

}  // namespace underact::test
