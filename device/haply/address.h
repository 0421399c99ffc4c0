#pragma once
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace underact::device::haply {

inline constexpr int kServicePort = 10001;  // where Haply's clients look for it

/// Where Haply's service listens, and which of its arms is meant.
struct Place {
  std::string host = "127.0.0.1";  // a name or a number; IPv6 without brackets
  int port = kServicePort;
  std::string id = {};  // of the Inverse3, as the service has it ("04C3"); empty: the first
  /// "HOST:PORT".
  std::string text() const;
};

/// "HOST:PORT", "HOST" or nothing, and "/ID" after it; the defaults above fill in what is missing. Problems: it is none
/// of these.
Result<Place> readPlace(std::string_view text);

}  // namespace underact::device::haply
