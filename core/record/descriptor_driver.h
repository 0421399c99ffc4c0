#pragma once
#include <cstdint>

#include "core/record/hdf5_id.h"

namespace underact::record {

/// The one name that a file list of accessThrough() opens; every other one, as links and foreign storage give them, is
/// refused.
inline constexpr const char* kGivenFile = "/session";

/// Makes an access list go by a descriptor that is open already, for reading alone: no file is ever opened by name.
/// at_least: so long the file is taken to be, with zeros where it has been cut off. false: the library refused.
bool accessThrough(Handle access, int fd, std::int64_t at_least);

}  // namespace underact::record
