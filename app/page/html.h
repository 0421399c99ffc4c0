#pragma once
#include <string>
#include <string_view>

namespace underact::page {

/// Text escaped for HTML, also in an attribute.
std::string escaped(std::string_view text);

/// The name that a heading is linked by, as GitHub makes it: "Loop rate, in Hz" is "loop-rate-in-hz".
std::string anchorOf(std::string_view heading);

}  // namespace underact::page
