#include "device/haply/haply.h"

#include "core/base/translate.h"
#include "device/haply/haply_arm.h"

namespace underact::device::haply {
namespace {

constexpr int kLook_ms = 60;  // for the answer of a busy computer; if nobody listens it is known at once

}  // namespace

Result<std::unique_ptr<servo::DevicePort>> openArm(const Request& request) {
  const Result<Place> place = readPlace(request.address);
  if (!place) return place.problems();
  Result<std::unique_ptr<HaplyArm>> arm = HaplyArm::open(place.value(), request.arm.geometry, request.rate_hz);
  if (!arm) return arm.problems();
  return std::unique_ptr<servo::DevicePort>(std::move(arm).value());
}

std::vector<Found> searchArms() {
  return searchAt({});
}

std::vector<Found> searchAt(const std::string& address) {
  const Result<Place> place = readPlace(address);
  if (!place) return {};
  Told told;
  hearMessage(getOverHttp(place.value(), "/devices", kLook_ms), told);
  std::vector<Found> found;
  for (const std::string& id : told.ids)
    found.push_back({phrase(TRANSLATE_NOOP("problem", "Inverse3 %1 at %2"), {id, place.value().text()}),
                     place.value().text() + "/" + id,
                     {}});
  return found;
}

}  // namespace underact::device::haply
