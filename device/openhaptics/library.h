#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "device/driver.h"
#include "device/openhaptics/abi.h"

namespace underact::device::openhaptics {

/// The environment variable that names another library than the usual ones.
inline constexpr const char* kPathVariable = "UNDERACT_OPENHAPTICS";

/// The vendor's library, bound once per process and never closed: it fails when it is loaded twice. Problems: missing()
/// as sentences. Any thread.
Result<const Calls*> load();

/// What load() lacks, and how to get it; empty: nothing.
std::vector<Missing> missing();

/// Binds all calls. resolve: the address of a name, or null. Problems: the missing names.
Problems bind(const std::function<void*(const char*)>& resolve, Calls& calls);

/// Explains the system's message about a library that could not be loaded. text: dlerror()'s.
Missing explain(std::string_view text);

}  // namespace underact::device::openhaptics
