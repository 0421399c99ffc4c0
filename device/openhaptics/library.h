#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "device/catalogue.h"
#include "device/openhaptics/abi.h"

namespace underact::device::openhaptics {

/// The variable that names another library than those that are looked for.
inline constexpr const char* kPathVariable = "UNDERACT_OPENHAPTICS";

/// The vendor's library, bound once in the life of the process and never closed: it fails when it is loaded twice.
/// Problems: missing() in words. Any thread.
Result<const Calls*> load();

/// What load() lacks, and what brings it; empty: nothing.
std::vector<Missing> missing();

/// Fills in all calls. resolve: the address of a name, or null. Problems: the names that are not there.
Problems bind(const std::function<void*(const char*)>& resolve, Calls& calls);

/// What the system's words for a library that could not be loaded mean. text: dlerror()'s.
Missing explain(std::string_view text);

}  // namespace underact::device::openhaptics
