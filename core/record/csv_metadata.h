#pragma once
#include <string>

#include "core/record/session.h"

namespace underact::record {

/// What a CSV file of that name, exported from the session, holds, as the W3C's CSV on the Web has it (tabular
/// metadata): each column with type, unit and meaning; in its notes the frames, and what was run. Problems: a text of
/// the session is damaged.
Result<std::string> csvMetadata(Session& session, const std::string& file_name);

/// Whether a session may be exported to a CSV file of that name: neither it nor the metadata beside it would be written
/// through a link, into a pipe, or over the session itself. Changes nothing.
Problems checkCsvNames(const std::string& session_path, const std::string& csv_path);

/// Writes it beside a CSV file: PATH-metadata.json, which its owner alone may read; an older file is replaced.
/// Problems, too: those of checkNew(); it cannot be written.
Problems writeCsvMetadata(Session& session, const std::string& csv_path);

}  // namespace underact::record
