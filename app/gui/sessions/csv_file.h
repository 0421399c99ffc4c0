#pragma once
#include <cstdint>
#include <string>

#include "app/gui/kit/background.h"
#include "core/base/result.h"

namespace underact::gui {

/// Result of an export.
struct CsvFile {
  std::int64_t rows = 0;     // written
  std::int64_t missing = 0;  // damaged in the session
  bool cancelled = false;    // then no file is left
  Problems problems;         // then no file is left either
};

/// Writes the ticks of a session as CSV, as underact-cli does. An existing file at out is replaced only when the new
/// one is complete.
CsvFile writeCsvFile(const std::string& session, const std::string& out, WorkState& state);

}  // namespace underact::gui
