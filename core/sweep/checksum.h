#pragma once
#include <string>
#include <string_view>

namespace underact::sweep {

/// 32 hexadecimal digits that tell contents apart, also those that differ by damage; no defence against forgery.
std::string checksumOf(std::string_view bytes);

}  // namespace underact::sweep
