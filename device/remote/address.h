#pragma once
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace underact::device::remote {

inline constexpr const char* kThisMachine = "127.0.0.1";
inline constexpr int kPort = 7878;

/// Where an arm is shared.
struct Address {
  std::string host = kThisMachine;  // a name or a number; of IPv6 without its brackets
  int port = kPort;
  bool isThisMachine() const;
  bool isIpv6() const { return host.find(':') != std::string::npos; }
  /// "HOST:PORT", as people write it and as files of keys have it.
  std::string text() const;
};

/// "HOST:PORT", "HOST" or nothing: what is missing is as above. A host of IPv6 stands in brackets. Port 0: any that is
/// free, for one who listens. Problems: it is none of these.
Result<Address> readAddress(std::string_view text);

}  // namespace underact::device::remote
