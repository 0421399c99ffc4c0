#include "core/lesson/results.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/printed.h"
#include "core/base/translate.h"
#include "core/json/json.h"
#include "core/system/named_file.h"

namespace underact::lesson {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestReport = std::size_t{1} << 20;
constexpr int kDeepest = 2;  // folders in the folder

/// The name that is there most often, of equals the first.
std::string mostFrequent(const std::vector<std::string>& names) {
  std::string most;
  std::ptrdiff_t times = 0;
  for (const std::string& name : names) {
    const std::ptrdiff_t its = std::count(names.begin(), names.end(), name);
    if (its > times) most = name, times = its;
  }
  return most;
}

ResultRow rowOf(const Report& report, const std::string& file) {
  ResultRow row;
  row.student = report.student, row.lesson = report.lesson, row.title = report.title, row.date = report.date;
  row.steps = report.steps.size(), row.minutes = report.minutes, row.report = file;
  std::vector<std::string> all;
  for (std::size_t at = 0; at < report.steps.size(); ++at) {
    const StepReport& step = report.steps[at];
    row.solved += step.solved ? 1 : 0;
    row.attempts += step.attempts, row.wrong += step.wrong;
    all.insert(all.end(), step.misconceptions.begin(), step.misconceptions.end());
    if (step.solved || row.stopped_at > 0) continue;
    row.stopped_at = at + 1, row.stopped_title = step.title;
    row.misconception = mostFrequent(step.misconceptions);
  }
  if (row.misconception.empty()) row.misconception = mostFrequent(all);
  return row;
}

bool isPage(const fs::directory_entry& entry) {
  const std::string suffix = entry.path().extension().string();
  return (suffix == ".html" || suffix == ".htm") && !entry.is_directory();
}

/// The pages, in the order of their names.
Result<std::vector<fs::path>> pagesIn(const std::string& folder) {
  std::vector<fs::path> pages;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (const fs::recursive_directory_iterator end; !error && at != end; at.increment(error)) {
    if (at.depth() >= kDeepest) at.disable_recursion_pending();
    if (isPage(*at)) pages.push_back(at->path());
    if (pages.size() > kMaxReports)
      return Problems{{phrase(TRANSLATE_NOOP("problem",
                                             "This folder holds more than %1 pages. Put the reports of one "
                                             "class into a folder of their own."),
                              {std::to_string(kMaxReports)}),
                       {folder}}};
  }
  if (error)
    return Problems{{phrase(TRANSLATE_NOOP("problem", "The folder cannot be read: %1."), {error.message()}), {folder}}};
  std::sort(pages.begin(), pages.end());
  return pages;
}

Result<std::string> readPage(const fs::path& path) {
  const Result<system::NamedFile> file =
      system::NamedFile::open(path.string(), phrase(TRANSLATE_NOOP("problem", "a report")));
  return file ? file.value().readAll(kLargestReport) : file.problems();
}

/// A later report comes first. Equals keep the order of their files.
bool isBefore(const ResultRow& a, const ResultRow& b) {
  return std::tie(a.student, a.lesson, b.date) < std::tie(b.student, b.lesson, a.date);
}

bool isSame(const ResultRow& a, const ResultRow& b) {
  return !a.student.empty() && a.student == b.student && a.lesson == b.lesson;
}

/// A field of CSV. Quotes hold it together for a spreadsheet that separates by semicolons, too.
std::string field(std::string_view words) {
  std::string text = printed(words);
  if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos) text.insert(0, 1, '\'');
  if (text.find_first_of(",;\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

std::string line(const std::vector<std::string>& fields) {
  std::string text;
  for (const std::string& one : fields) text += one + ",";
  text.back() = '\n';
  return text;
}

}  // namespace

Result<ClassResults> readResults(const std::string& folder) {
  const Result<std::vector<fs::path>> pages = pagesIn(folder);
  if (!pages) return pages.problems();
  ClassResults results;
  std::vector<ResultRow> rows;
  for (const fs::path& path : pages.value()) {
    const Result<std::string> page = readPage(path);
    const Result<Report> report = page ? readReport(page.value(), path.string()) : page.problems();
    if (report) rows.push_back(rowOf(report.value(), path.lexically_relative(folder).string()));
    if (!report) results.unread.push_back({report.problems().front().sentence, {path.string()}});
  }
  std::stable_sort(rows.begin(), rows.end(), isBefore);
  for (ResultRow& row : rows) {
    if (results.rows.empty() || !isSame(results.rows.back(), row)) {
      results.rows.push_back(std::move(row));
      continue;
    }
    results.older.push_back(
        {phrase(TRANSLATE_NOOP("problem", "%1 has a later report of this lesson, %2, which counts."),
                {printed(row.student), printed(results.rows.back().report)}),
         {(fs::path(folder) / row.report).string()}});
  }
  return results;
}

std::string resultsCsv(const ClassResults& results) {
  std::string text =
      "student,lesson,steps,solved,stopped_at,attempts,minutes,misconception,report,title,date,wrong,stopped_title\n";
  for (const ResultRow& row : results.rows) {
    text += line({field(row.student), field(row.lesson), std::to_string(row.steps), std::to_string(row.solved),
                  row.stopped_at > 0 ? std::to_string(row.stopped_at) : "", std::to_string(row.attempts),
                  json::numberText(row.minutes), field(row.misconception), field(row.report), field(row.title),
                  field(row.date), std::to_string(row.wrong), field(row.stopped_title)});
  }
  return text;
}

std::string moodleCsv(const ClassResults& results) {
  std::map<std::string, std::string> lessons;  // by the name of its file, as its title depends on the language
  std::map<std::string, std::map<std::string, std::string>> grades;
  for (const ResultRow& row : results.rows) {
    if (row.student.empty()) continue;
    lessons.emplace(row.lesson, row.title);
    const double percent = 100.0 * static_cast<double>(row.solved) / static_cast<double>(row.steps);
    grades[row.student][row.lesson] = json::numberText(std::round(100.0 * percent) / 100.0);
  }
  std::vector<std::string> fields{"Student"};
  for (const auto& [lesson, title] : lessons) fields.push_back(field(title));
  std::string text = line(fields);
  for (auto& [student, its] : grades) {
    fields = {field(student)};
    for (const auto& [lesson, title] : lessons) fields.push_back(its[lesson]);
    text += line(fields);
  }
  return text;
}

std::size_t withoutName(const ClassResults& results) {
  return static_cast<std::size_t>(std::count_if(results.rows.begin(), results.rows.end(),
                                                [](const ResultRow& row) { return row.student.empty(); }));
}

}  // namespace underact::lesson
