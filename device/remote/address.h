#pragma once
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace underact::device::remote {

inline constexpr const char* kThisMachine = "127.0.0.1";
inline constexpr int kPort = 7878;

/// Where an arm is shared.
struct Address {
  std::string host = kThisMachine;  // a name or a number; IPv6 without brackets
  int port = kPort;
  bool isThisMachine() const;
  bool isIpv6() const { return host.find(':') != std::string::npos; }
  /// "HOST:PORT", as people write it and as key files have it.
  std::string text() const;
};

/// "HOST:PORT", "HOST" or nothing: the defaults above fill in what is missing. An IPv6 host is in brackets. Port 0: any
/// free one, for listening. Problems: it is none of these.
Result<Address> readAddress(std::string_view text);

}  // namespace underact::device::remote
