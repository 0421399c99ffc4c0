#include "device/remote/remote.h"

#include "core/base/translate.h"
#include "device/remote/endpoint.h"
#include "device/remote/remote_arm.h"

namespace underact::device::remote {
namespace {

constexpr int kPoll_ms = 60;  // for the handshake on a busy computer; if nobody listens it is known at once

}  // namespace

Result<std::unique_ptr<servo::DevicePort>> openArm(const Request& request) {
  const Result<Address> address = readAddress(request.address);
  if (!address) return address.problems();
  const Result<Endpoint> endpoint = endpointOf(address.value(), KeyFolder());
  if (!endpoint) return endpoint.problems();
  Result<std::unique_ptr<RemoteArm>> arm = RemoteArm::open(endpoint.value(), request.arm, request.rate_hz);
  if (!arm) return arm.problems();
  return std::unique_ptr<servo::DevicePort>(std::move(arm).value());
}

std::vector<Found> searchArms() {
  const Address here;
  if (!KeyFolder().hasOwn()) return {};  // a user without a key shares nothing, and looking creates none
  const Result<Endpoint> endpoint = endpointOf(here, KeyFolder());
  if (!endpoint) return {};
  const Result<Welcome> welcome = queryArm(endpoint.value(), kPoll_ms);
  if (!welcome) return {};
  const char* const title = welcome.value().allows_force
                                ? TRANSLATE_NOOP("problem", "%1, shared on this computer")
                                : TRANSLATE_NOOP("problem", "%1, shared on this computer, without force");
  return {{phrase(title, {welcome.value().title}), here.text(), {}}};
}

}  // namespace underact::device::remote
