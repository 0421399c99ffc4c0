#include "app/gui/sessions/csv_export.h"

#include <filesystem>

#include "core/record/csv.h"
#include "core/record/session.h"

namespace underact::gui {
namespace {

Problems writeRows(record::Session& session, record::CsvWriter& writer, WorkState& state, CsvExport& done) {
  return session.eachBlock(
      [&](const record::Block& block, std::int64_t) {
        for (const servo::TickRecord& record : record::unpackTicks(block)) writer.add(record);
        done.rows += block.rows;
        return !state.cancelled && !writer.hasFailed();
      },
      [&done](const record::Gap& gap) { done.missing += gap.rows; }, [&state](double share) { state.share = share; });
}

}  // namespace

CsvExport exportCsv(const std::string& session, const std::string& out, WorkState& state) {
  CsvExport done;
  Result<record::Session> read = record::Session::open(session);
  if (!read) {
    done.problems = read.problems();
    return done;
  }
  const std::string part = out + ".part";
  Result<record::CsvWriter> writer = record::CsvWriter::open(part);
  if (!writer) {
    done.problems = {{"The file cannot be made there. Choose another folder.", {out}}};
    return done;
  }
  record::CsvWriter file = std::move(writer).value();
  done.problems = writeRows(read.value(), file, state, done);
  const Problems unwritten = file.close();
  done.problems.insert(done.problems.end(), unwritten.begin(), unwritten.end());
  done.cancelled = state.cancelled;
  std::error_code error;
  if (done.cancelled || !done.problems.empty()) {
    std::filesystem::remove(part, error);
    return done;
  }
  std::filesystem::rename(part, out, error);
  if (error) {
    done.problems = {{"The file that stands there cannot be replaced. Choose another name.", {out}}};
    std::filesystem::remove(part, error);
  }
  return done;
}

}  // namespace underact::gui
