#pragma once
#include <string>
#include <string_view>

namespace underact::test {

/// What a file of points of any bytes may do: be refused, each problem with its line and a sentence, or give finite
/// points, no two neighbours equal, whose curves, where there are any, have a finite nearest point. Empty: it did one
/// of the two; else what went wrong.
std::string judgePoints(std::string_view text);

/// Whether judgePoints() saw it accepted.
bool arePoints(std::string_view text);

}  // namespace underact::test
