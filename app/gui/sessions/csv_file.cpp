#include "app/gui/sessions/csv_file.h"

#include <QtGlobal>
#include <filesystem>

#include "core/record/csv.h"
#include "core/record/csv_metadata.h"

namespace underact::gui {

CsvFile writeCsvFile(const std::string& session, const std::string& out, WorkState& state) {
  Result<record::Session> read = record::Session::open(session);
  if (!read) return {.problems = read.problems()};
  if (Problems problems = record::checkCsvNames(session, out); !problems.empty())
    return {.problems = std::move(problems)};
  const std::string part = out + ".part";
  Result<record::CsvWriter> writer = record::CsvWriter::create(part, system::Existing::Replace);
  if (!writer)
    return {
        .problems = {
            {phrase(QT_TRANSLATE_NOOP("problem", "The file cannot be created there. Choose another folder.")), {out}}}};
  const record::CsvExport exported = record::exportCsv(read.value(), writer.value(), [&state](double share) {
    state.share = share;
    return !state.cancelled;
  });
  CsvFile done{exported.rows, exported.missing, state.cancelled, exported.unread};
  done.problems.insert(done.problems.end(), exported.unwritten.begin(), exported.unwritten.end());
  std::error_code error;
  if (done.cancelled || !done.problems.empty()) {
    std::filesystem::remove(part, error);
    return done;
  }
  std::filesystem::rename(part, out, error);
  if (error) {
    done.problems = {
        {phrase(QT_TRANSLATE_NOOP("problem", "The existing file cannot be replaced. Choose another name.")), {out}}};
    std::filesystem::remove(part, error);
    return done;
  }
  const Problems undescribed = record::writeCsvMetadata(read.value(), out);
  done.problems.insert(done.problems.end(), undescribed.begin(), undescribed.end());
  return done;
}

}  // namespace underact::gui
