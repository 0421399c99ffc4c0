#pragma once
#include <cstdint>

#include "core/record/hdf5_id.h"

namespace underact::record {

/// The one name that a file access list of accessThrough() opens; every other one, as of links and external storage, is
/// refused.
inline constexpr const char* kGivenFile = "/session";

/// Makes a file access list read through a descriptor that is open already: no file is ever opened by name. at_least:
/// the length that the file is taken to have at least, with zeros where it was truncated. false: the library refused.
bool accessThrough(Handle access, int fd, std::int64_t at_least);

}  // namespace underact::record
