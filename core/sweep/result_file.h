#pragma once
#include <string>

#include "core/base/result.h"
#include "core/sweep/journal.h"
#include "core/sweep/sweep.h"

namespace underact::sweep {

/// Whether the result of this sweep is at path already, whole. Problems: something else is there, which is not
/// overwritten.
Result<bool> isThere(const Sweep& sweep, const std::string& path);

/// Writes the header and all rows in the order of the cells, into a file that is not there yet; path has all of it, or
/// what it had. Problems: it cannot be written; something has come to be at path, or at path.new, where it is first.
Problems writeResult(const Sweep& sweep, const Rows& rows, const std::string& path);

}  // namespace underact::sweep
