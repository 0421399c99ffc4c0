#pragma once
#include <span>
#include <string_view>

#include "core/sweep/kind.h"

namespace underact::sweep {

/// Every kind of sweep there is, in the order of `underact-sweep list`.
std::span<const Kind> kinds();

/// The kind of that key, or null.
const Kind* findKind(std::string_view key);

}  // namespace underact::sweep
