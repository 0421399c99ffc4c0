#include "device/haply/address.h"

#include <algorithm>

#include "core/base/translate.h"
#include "device/remote/address.h"

namespace underact::device::haply {
namespace {

bool isOfIds(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

}  // namespace

std::string Place::text() const {
  return remote::Address{host, port}.text();
}

Result<Place> readPlace(std::string_view text) {
  constexpr std::size_t kLongestId = 64, kLongestShown = 300;
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::string_view id = text.substr(std::min(slash + 1, text.size()));
  const std::string_view address = text.substr(0, slash);
  Result<remote::Address> read = remote::readAddress(address);
  const bool names_one = slash < text.size();
  const bool is_id = id.size() <= kLongestId && std::all_of(id.begin(), id.end(), isOfIds) && names_one == !id.empty();
  if (!read || read.value().port == 0 || !is_id)
    return Problems{
        {phrase(
             TRANSLATE_NOOP("problem",
                            "\"%1\" is not an address of Haply's service. Give HOST:PORT or HOST, and /ID for one of "
                            "several arms, as in 127.0.0.1:10001 or 127.0.0.1:10001/04C3."),
             {std::string(text.substr(0, kLongestShown))}),
         {}}};
  Place place{read.value().host, read.value().port, std::string(id)};
  const bool has_port = address.find(':', address.rfind(']') == std::string_view::npos ? 0 : address.rfind(']')) !=
                        std::string_view::npos;
  if (!has_port) place.port = kServicePort;
  return place;
}

}  // namespace underact::device::haply
