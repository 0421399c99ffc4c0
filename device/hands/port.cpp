#include "device/hands/port.h"

#include <map>

namespace underact::device::hands {

void tellApart(std::vector<Seen>& seen) {
  std::map<std::string, int> so_far;
  for (Seen& one : seen) {
    const int number = ++so_far[one.id];
    if (number > 1) one.id += "-" + std::to_string(number);
  }
}

}  // namespace underact::device::hands
