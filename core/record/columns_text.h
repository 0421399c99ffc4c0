#pragma once
#include <string>

namespace underact::record {

/// The table of all columns of a session as one JSON object: {"underact_columns": 1, "tables": [...], "csv": [...]}.
/// The Python package reads it from underact/columns.json.
std::string columnsJson();

/// The columns as a page of the guide.
std::string columnsPage();

}  // namespace underact::record
