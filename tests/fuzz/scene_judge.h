#pragma once
#include <string>
#include <string_view>

namespace underact::test {

/// What a scene file of any bytes may do: be refused, each problem with its place and a sentence, or compile, read back
/// to the last bit after writing, and tick without breaking the gate. Empty: it did one of the two; else what went
/// wrong.
std::string judgeScene(std::string_view text);

/// Whether judgeScene() saw it accepted.
bool isAccepted(std::string_view text);

}  // namespace underact::test
