#include "device/remote/address.h"

#include <algorithm>
#include <charconv>

#include "core/base/translate.h"

namespace underact::device::remote {
namespace {

constexpr std::size_t kLongestName = 253;  // of DNS
constexpr int kLastPort = 65535;

bool isOfHosts(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_';
}

bool isOfIpv6(char c) {
  return (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F') || (c >= '0' && c <= '9') || c == '.' || c == ':';
}

Problems wrong(std::string_view text) {
  return {{phrase(TRANSLATE_NOOP("problem",
                                 "\"%1\" is not an address of a shared arm. Give HOST:PORT or HOST, as in "
                                 "192.168.1.20:7878, arm-pc or [fe80::1]:7878."),
                  {std::string(text)}),
           {}}};
}

}  // namespace

bool Address::isThisMachine() const {
  // A number alone: a name may begin with 127, too.
  return host == "localhost" || host == "::1" ||
         (host.starts_with("127.") && host.find_first_not_of("0123456789.") == std::string::npos);
}

std::string Address::text() const {
  return (isIpv6() ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

Result<Address> readAddress(std::string_view text) {
  Address address;
  if (text.empty()) return address;
  std::string_view host = text, rest;
  if (text.front() == '[') {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) return wrong(text);
    host = text.substr(1, end - 1);
    rest = text.substr(end + 1);
    if (host.find(':') == std::string_view::npos || !std::all_of(host.begin(), host.end(), isOfIpv6))
      return wrong(text);
  } else {
    const std::size_t colon = std::min(text.find(':'), text.size());
    host = text.substr(0, colon);
    rest = text.substr(colon);
    if (!std::all_of(host.begin(), host.end(), isOfHosts) || (!host.empty() && host.front() == '-')) return wrong(text);
  }
  if (host.size() > kLongestName) return wrong(text.substr(0, kLongestName));
  if (!host.empty()) address.host = host;
  if (rest.empty()) return address;
  const char* const end = rest.data() + rest.size();
  const auto read = std::from_chars(rest.data() + 1, end, address.port);
  const bool is_port = rest.front() == ':' && rest.size() > 1 && read.ec == std::errc() && read.ptr == end;
  if (!is_port || address.port < 0 || address.port > kLastPort) return wrong(text);
  return address;
}

}  // namespace underact::device::remote
