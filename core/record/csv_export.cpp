#include "core/record/csv_export.h"

#include "core/record/tick_table.h"

namespace underact::record {

CsvExport exportCsv(Session& session, CsvWriter& csv, const std::function<bool(double share)>& goes_on) {
  CsvExport done;
  done.unread = session.eachBlock(
      [&](const Block& block, std::int64_t) {
        for (const servo::TickRecord& record : unpackTicks(block)) csv.add(record);
        done.rows += block.rows;
        const auto seen = static_cast<double>(done.rows + done.missing);
        done.is_stopped = !goes_on(seen / static_cast<double>(session.info().ticks));
        return !done.is_stopped && !csv.hasFailed();
      },
      [&done](const Gap& gap) { done.missing += gap.rows; });
  done.unwritten = csv.close();
  return done;
}

}  // namespace underact::record
