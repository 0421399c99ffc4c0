#include "core/record/csv.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/base/translate.h"
#include "core/record/columns.h"
#include "core/record/tick_table.h"
#include "core/system/file.h"

namespace underact::record {
namespace {

std::string header(bool more_joints) {
  std::string text;
  for (const CsvField& field : csvFields(more_joints)) text.append(text.empty() ? "" : ",").append(field.name);
  return text + "\n";
}

/// One line, in place: numbers of at most 25 characters, and what separates them.
class Row {
 public:
  template <class Integer>
  void integer(Integer value) {
    end_ = std::to_chars(end_, text_.data() + text_.size(), value).ptr;
    separate();
  }
  /// An empty field where it is not finite: every reader of tables takes it for a missing value.
  void number(double value) {
    if (std::isfinite(value)) end_ = std::to_chars(end_, text_.data() + text_.size(), value).ptr;
    separate();
  }
  void word(FaultKind fault) {
    const std::string_view value = name(fault);
    end_ = std::copy(value.begin(), value.end(), end_);
    separate();
  }
  std::string_view finished() {
    end_[-1] = '\n';
    return {text_.data(), static_cast<std::size_t>(end_ - text_.data())};
  }

 private:
  void separate() { *end_++ = ','; }
  std::array<char, 26 * kCsvNumbers> text_{};
  char* end_ = text_.data();
};

}  // namespace

Result<CsvWriter> CsvWriter::toOutput() {
  return into(system::Descriptor::copyOf(system::kOutput), "standard output");
}

Result<CsvWriter> CsvWriter::create(const std::string& path, system::Existing existing) {
  if (Problems problems = system::checkNew(path, existing); !problems.empty()) return problems;
  return into(system::makeNew(path, existing), path);
}

Result<CsvWriter> CsvWriter::into(system::Descriptor made, const std::string& path) {
  std::FILE* const file = system::streamOf(std::move(made));
  if (file == nullptr)
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "The recording cannot be started: %1."), {std::strerror(errno)}), {path}}};
  return CsvWriter(file, path);
}

void CsvWriter::writeHeader() {
  if (std::exchange(has_header_, true)) return;
  write(header(more_joints_));
}

void CsvWriter::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) error_ = errno;
}

void CsvWriter::add(const servo::TickRecord& record) {
  if (error_ != 0) return;
  if (!has_header_) more_joints_ = more_joints_ || record.joints > 6;
  writeHeader();
  Row row;
  fillRow(record, row, more_joints_);
  write(row.finished());
}

Problems CsvWriter::close() {
  if (file_ == nullptr) return {};
  writeHeader();  // of a recording without a row
  if (std::fflush(file_.get()) != 0 && error_ == 0) error_ = errno;
  if (std::fclose(file_.release()) != 0 && error_ == 0) error_ = errno;
  if (error_ == 0) return {};
  return {{phrase(TRANSLATE_NOOP("problem", "The recording is incomplete: %1."), {std::strerror(error_)}), {path_}}};
}

CsvExport exportCsv(Session& session, CsvWriter& csv, const std::function<bool(double share)>& goes_on) {
  CsvExport done;
  csv.setMoreJoints(session.hasMoreJoints());
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
