#pragma once
#include <cstdint>
#include <string>

#include "app/gui/kit/background.h"
#include "core/base/result.h"

namespace underact::gui {

/// What came of an export.
struct CsvFile {
  std::int64_t rows = 0;     // written
  std::int64_t missing = 0;  // that are damaged in the session
  bool cancelled = false;    // no file is left then
  Problems problems;         // nor then
};

/// Writes the ticks of a session as CSV, as underact-cli does. What is at out stays until the new file is whole.
CsvFile writeCsvFile(const std::string& session, const std::string& out, WorkState& state);

}  // namespace underact::gui
