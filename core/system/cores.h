#pragma once
#include <optional>
#include <string_view>

namespace underact::system {

/// The first core of a list in the format of Linux ("2-3,7"); none where the list is empty or malformed.
std::optional<int> firstCore(std::string_view list);

}  // namespace underact::system
