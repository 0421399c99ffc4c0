#pragma once
#include <string>

#include "core/base/result.h"
#include "core/sweep/journal.h"
#include "core/sweep/sweep.h"

namespace underact::sweep {

/// Whether the complete result of this sweep exists at path. Problems: another file is there, which is not overwritten.
Result<bool> isThere(const Sweep& sweep, const std::string& path);

/// Writes the header and all rows in the order of the cells, into a new file: path has the whole result or is
/// unchanged. Problems: it cannot be written; a file has appeared at path, or at path.new, where it is written first.
Problems writeResult(const Sweep& sweep, const Rows& rows, const std::string& path);

}  // namespace underact::sweep
