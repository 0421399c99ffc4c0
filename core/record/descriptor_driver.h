#pragma once
#include <cstdint>

#include "core/record/hdf5_id.h"

namespace underact::record {

/// The only name that a file access list of accessThrough() opens; all others, from links and external storage, are
/// refused.
inline constexpr const char* kGivenFile = "/session";

/// Makes an access list use an open descriptor, for reading only: no file is ever opened by name. at_least: the file is
/// taken to be at least this long, with zeros where it was truncated. false: the library refused.
bool accessThrough(Handle access, int fd, std::int64_t at_least);

}  // namespace underact::record
