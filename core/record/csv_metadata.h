#pragma once
#include <string>

#include "core/record/session.h"

namespace underact::record {

/// What a CSV file of that name, exported from the session, holds, as the W3C's CSV on the Web has it (tabular
/// metadata): each column with type, unit and meaning; in its notes the frames, and what was run. Problems: a text of
/// the session is damaged.
Result<std::string> csvMetadata(Session& session, const std::string& file_name);

/// Writes it beside a CSV file: PATH-metadata.json, which its owner alone may read; an older one is replaced. Problems,
/// too: it cannot be written.
Problems writeCsvMetadata(Session& session, const std::string& csv_path);

}  // namespace underact::record
