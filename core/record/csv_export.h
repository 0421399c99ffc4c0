#pragma once
#include <cstdint>
#include <functional>

#include "core/record/csv.h"
#include "core/record/session.h"

namespace underact::record {

/// What came of an export.
struct CsvExport {
  std::int64_t rows = 0;     // written
  std::int64_t missing = 0;  // that are damaged in the session
  bool is_stopped = false;   // before its end, as was asked
  Problems unread;           // why no more was read
  Problems unwritten;        // what is there is whole up to a line
  bool isWhole() const { return missing == 0 && !is_stopped && unread.empty() && unwritten.empty(); }
};

/// Writes the ticks of a session as CSV and closes the file. goes_on: asked after each block, told the share that is
/// done; false ends the export there.
CsvExport exportCsv(Session& session, CsvWriter& csv, const std::function<bool(double share)>& goes_on);

}  // namespace underact::record
