#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace underact::test {

/// What any bytes from the network may do: be refused, or be a message that is written with these very bytes, so that
/// there is no second way to say the same. Empty: it did one of the two; else what went wrong.
std::string judgeRemote(std::span<const std::uint8_t> bytes);

}  // namespace underact::test
