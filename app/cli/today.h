#pragma once
#include <string>

namespace underact::cli {

/// "2026-11-22", by UTC.
std::string today();

}  // namespace underact::cli
