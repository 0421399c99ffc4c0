#include "tests/contract/drivers.h"

namespace underact::test {

std::vector<Driver> drivers() {
  return {
      {"simulated", simulatedFarSide}, {"replayed", replayedFarSide},          {"wooden_v1", woodenV1FarSide},
      {"wooden_v2", woodenV2FarSide},  {"wooden_teensy", woodenTeensyFarSide},
  };
}

}  // namespace underact::test
