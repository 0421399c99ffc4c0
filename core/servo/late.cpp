#include "core/servo/late.h"

namespace underact::servo {

const char* name(LateCause cause) {
  switch (cause) {
    case LateCause::Overrun:
      return "overrun";
    case LateCause::Device:
      return "device";
    case LateCause::PageFault:
      return "page_fault";
    case LateCause::Preempted:
      return "preempted";
    case LateCause::Woken:
      return "woken";
  }
  return "woken";
}

}  // namespace underact::servo
