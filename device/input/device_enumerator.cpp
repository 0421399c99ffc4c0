#include "device/input/device_enumerator.h"

#include <map>

namespace underact::device::input {

void makeIdsUnique(std::vector<DeviceState>& seen) {
  std::map<std::string, int> so_far;
  for (DeviceState& one : seen) {
    const int number = ++so_far[one.id];
    if (number > 1) one.id += "-" + std::to_string(number);
  }
}

}  // namespace underact::device::input
