#include "tests/contract/drivers.h"

namespace underact::test {

std::vector<Driver> drivers() {
  return {
      {"simulated", simulatedFarSide},
      {"replayed", replayedFarSide},
      {"openhaptics", openHapticsFarSide},
  };
}

}  // namespace underact::test
