#include "core/servo/late.h"

#include <algorithm>

#include "core/base/units.h"

namespace underact::servo {

double waited_s(std::int64_t lateness_ns, std::int64_t period_ns) noexcept {
  constexpr std::int64_t kLongest_ns = 3'600'000'000'000;
  const std::int64_t left_out =
      std::clamp<std::int64_t>(lateness_ns, 0, kLongest_ns) / std::max<std::int64_t>(period_ns, 1);
  return kSecondPerNanosecond * static_cast<double>(left_out * period_ns);
}

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
