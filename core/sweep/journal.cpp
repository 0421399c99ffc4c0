#include "core/sweep/journal.h"

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/json/text.h"
#include "core/sweep/build.h"
#include "core/system/file.h"
#include "underact/version.h"

namespace underact::sweep {
namespace {

constexpr std::size_t kChecksum = 16;  // digits for each line: one in 2^64 damaged lines is not detected
constexpr std::size_t kLargestJournal = std::size_t{8} << 30U;  // larger than any result that a table program opens
constexpr std::string_view kFirst = "underact-sweep-journal 1 ";

/// A line of the journal. The checksum includes the sweep's fingerprint, so that no line of another sweep counts.
std::string lineOf(const std::string& fingerprint, const std::string& text) {
  return checksumOf(fingerprint + text).substr(0, kChecksum) + " " + text + "\n";
}

/// The text of a line without its end; none: it is damaged.
std::optional<std::string> textIn(const std::string& fingerprint, std::string_view line) {
  if (line.size() <= kChecksum) return {};
  std::string text(line.substr(kChecksum + 1));
  if (lineOf(fingerprint, text) != std::string(line) + "\n") return {};
  return text;
}

std::string firstLine(const Sweep& sweep) {
  return std::string(kFirst) + sweep.fingerprint + " kind " + sweep.kind + ", seed " + std::to_string(sweep.seed) +
         ", version " + kVersion + "\n";
}

Problems systemProblem(const std::string& path, const std::string& what, int error) {
  return problemAt(path, what + ": " + std::generic_category().message(error) + ".");
}

/// Cell and row of "CELL ROW"; none: another format.
std::optional<std::pair<std::size_t, std::string>> cellIn(const std::string& text) {
  std::size_t cell = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, cell);
  if (error != std::errc() || at == end || *at != ' ') return {};
  return std::pair{cell, std::string(at + 1, end)};
}

/// Why a journal cannot be used. first: its first line, with its end.
std::string refusal(std::string_view first, std::size_t fingerprint) {
  const std::size_t words = kFirst.size() + fingerprint + 1;
  const bool is_known = first.starts_with(kFirst) && first.size() > words;
  const std::string whose = is_known ? "another sweep (" + std::string(first.substr(words, first.size() - words - 1)) +
                                           "), or of another build, other options or files"
                                     : "an unknown sweep";
  return "This journal is of " + whose + ". Choose another --out, or remove the journal, which discards its cells.";
}

}  // namespace

std::string journalOf(const std::string& result) {
  return result + ".part";
}

Journal::Journal(std::string path, std::string fingerprint, system::Descriptor file)
    : path_(std::move(path)), fingerprint_(std::move(fingerprint)), file_(std::move(file)) {}

Result<Journal> Journal::open(const Sweep& sweep, const std::string& result) {
  const std::string path = journalOf(result);
  system::Descriptor file = system::makeFile(path, system::Making::Further, system::Readers::Default);
  if (!file.isOpen()) return systemProblem(path, "The journal of finished cells cannot be opened", errno);
  if (!system::lock(file.number(), system::Lock::Alone))
    return problemAt(path,
                     "Another underact-sweep is working on this result. Wait until it ends, or choose another --out.");
  Journal journal(path, sweep.fingerprint, std::move(file));
  Problems problems = journal.read(sweep);
  if (!problems.empty()) return problems;
  return journal;
}

Problems Journal::read(const Sweep& sweep) {
  const Result<std::string> file = json::readTextFile(path_, "a journal", kLargestJournal);
  if (!file) return file.problems();
  const std::string& text = file.value();
  const std::string first = firstLine(sweep);
  const std::string_view here = std::string_view(text).substr(0, text.find('\n') + 1);
  const bool is_torn_first = here.empty() && (text.starts_with(kFirst) || kFirst.starts_with(text));
  if (here != first && !is_torn_first) return problemAt(path_, refusal(here, sweep.fingerprint.size()));
  const std::size_t whole = text.rfind('\n') + 1;  // what follows is an incomplete line; without a line, 0
  if (const int reason = system::cutTo(file_.number(), whole); reason != 0)
    return systemProblem(path_, "The journal of finished cells cannot be written", reason);
  if (whole == 0) return write(first);
  for (std::size_t at = here.size(); at < whole;) {
    const std::size_t end = text.find('\n', at);
    const auto line = textIn(fingerprint_, std::string_view(text).substr(at, end - at));
    at = end + 1;
    if (!line) continue;
    auto found = cellIn(*line);
    if (found && found->first < sweep.cells.count) rows_.insert(std::move(*found));
  }
  return {};
}

Problems Journal::write(const std::string& line) {
  const int reason = system::writeAll(file_.number(), std::as_bytes(std::span(line)));
  return reason == 0 ? Problems{} : systemProblem(path_, "The journal cannot be extended", reason);
}

Problems Journal::add(std::size_t cell, const std::string& row) {
  if (rows_.contains(cell)) return {};
  Problems problems = write(lineOf(fingerprint_, std::to_string(cell) + " " + row));
  if (problems.empty()) rows_.emplace(cell, row);
  return problems;
}

void Journal::remove() {
  std::remove(path_.c_str());
}

}  // namespace underact::sweep
