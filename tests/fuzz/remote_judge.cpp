#include "tests/fuzz/remote_judge.h"

#include <algorithm>

#include "device/remote/message.h"

namespace underact::test {

std::string judgeRemote(std::span<const std::uint8_t> bytes) {
  const auto message = device::remote::readMessage(bytes);
  if (!message) return {};
  const std::vector<std::uint8_t> again = device::remote::bytesOf(*message);
  if (!std::equal(again.begin(), again.end(), bytes.begin(), bytes.end())) return "Written otherwise than it was read.";
  if (const auto* force = std::get_if<device::remote::ForceMessage>(&*message);
      force != nullptr && !force->f_T_W.allFinite())
    return "A force that is no number.";
  return {};
}

}  // namespace underact::test
