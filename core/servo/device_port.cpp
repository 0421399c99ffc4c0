#include "core/servo/device_port.h"

#include "core/base/translate.h"

namespace underact::servo {

Sentence DevicePort::fixedRateReason() const {
  return phrase(TRANSLATE_NOOP("problem", "This arm keeps the rate that it was opened with."));
}

}  // namespace underact::servo
