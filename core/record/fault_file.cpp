#include "core/record/fault_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "core/base/translate.h"
#include "core/json/json.h"
#include "core/json/object_text.h"
#include "core/record/columns.h"
#include "core/scene/load_meshes.h"
#include "core/scene/write.h"
#include "core/system/file.h"
#include "core/system/private_file.h"
#include "underact/version.h"

namespace underact::record {
namespace {

constexpr std::string_view kFileBegin = "fault_";
constexpr std::string_view kFileEnd = ".json";
constexpr int kMaxInASecond = 99;

/// A row as a JSON list.
class JsonRow {
 public:
  explicit JsonRow(std::string& text) : text_(text) {}
  template <class Integer>
  void integer(Integer value) {
    add(std::to_string(value));
  }
  void number(double value) { add(json::numberText(value)); }
  void word(FaultKind fault) { add(json::quotedText(name(fault))); }

 private:
  void add(std::string_view value) {
    text_.append(first_ ? "" : ", ").append(value);
    first_ = false;
  }
  std::string& text_;
  bool first_ = true;
};

void member(std::string& text, std::string_view key, std::string_view json) {
  text.append(text.empty() ? "{\n  " : ",\n  ").append(json::quotedText(key)).append(": ").append(json);
}

std::string lateText(const servo::LateTicks& late) {
  json::ObjectText object;
  object.addInteger("total", late.total);
  for (std::size_t cause = 0; cause < late.by_cause.size(); ++cause)
    object.addInteger(servo::name(static_cast<servo::LateCause>(cause)), late.by_cause[cause]);
  object.addInteger("left_out", late.left_out);
  return object.text();
}

bool haveMoreJoints(const std::vector<servo::TickRecord>& records) {
  return std::any_of(records.begin(), records.end(), [](const servo::TickRecord& record) { return record.joints > 6; });
}

std::string rowsText(const std::vector<servo::TickRecord>& records) {
  std::string text = "[";
  const bool more_joints = haveMoreJoints(records);
  for (const servo::TickRecord& record : records) {
    text += text.size() > 1 ? ",\n    [" : "\n    [";
    JsonRow row(text);
    fillRow(record, row, more_joints);
    text += "]";
  }
  return text + "]";
}

std::string twoDigits(int value) {
  return (value < 10 ? "0" : "") + std::to_string(value);
}

Problems cannotBeSaved(const std::string& path, int error) {
  return {{phrase(TRANSLATE_NOOP("problem", "The fault cannot be written to a file: %1."), {std::strerror(error)}),
           {path}}};
}

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// The faults saved in a folder, by name: names begin with the time, so the oldest is first.
std::vector<std::filesystem::path> faultsIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(kFileBegin) && name.ends_with(kFileEnd)) found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Removes the oldest faults, but never the newest one, which looks old if the clock was set back.
void removeOldest(const std::filesystem::path& folder, const std::filesystem::path& newest) {
  const std::vector<std::filesystem::path> found = faultsIn(folder);
  std::size_t kept = found.size();
  for (const std::filesystem::path& one : found) {
    if (kept <= kFaultFilesKept) return;
    if (one == newest) continue;
    std::error_code left_there;
    std::filesystem::remove(one, left_there);
    --kept;
  }
}

}  // namespace

FaultWords wordsOf(const Fault& fault) {
  return {name(fault.kind), whatHappened(fault), whatToDo(fault)};
}

FaultWords wordsOf(const servo::FaultReport& report) {
  FaultWords words = wordsOf(report.fault);
  words.what = oneAfterAnother({words.what, report.trouble});
  return words;
}

std::string isoTime(std::int64_t unix_time_s) {
  using namespace std::chrono;
  const sys_seconds time{seconds{unix_time_s}};
  const year_month_day day{floor<days>(time)};
  const hh_mm_ss clock{time - floor<days>(time)};
  std::string year = std::to_string(static_cast<int>(day.year()));
  year.insert(0, year.size() < 4 ? 4 - year.size() : 0, '0');
  return year + "-" + twoDigits(static_cast<int>(static_cast<unsigned>(day.month()))) + "-" +
         twoDigits(static_cast<int>(static_cast<unsigned>(day.day()))) + "T" +
         twoDigits(static_cast<int>(clock.hours().count())) + ":" +
         twoDigits(static_cast<int>(clock.minutes().count())) + ":" +
         twoDigits(static_cast<int>(clock.seconds().count())) + "Z";
}

std::string faultText(const servo::FaultReport& report, const FaultWords& words) {
  std::string text, columns;
  for (const CsvField& field : csvFields(haveMoreJoints(report.last_second)))
    columns.append(columns.empty() ? "[" : ", ").append(json::quotedText(field.name));
  json::ObjectText device, scheduling;
  device.addText("title", report.device.title);
  device.addBool("simulated", report.device.simulated);
  device.addBool("untested", report.device.untested);
  scheduling.addText("name", report.scheduling.name);
  scheduling.addTexts("also", {report.scheduling.also.begin(), report.scheduling.also.end()});
  member(text, "underact_fault", "1");
  member(text, "program", json::quotedText(kVersion));
  member(text, "what", json::quotedText(words.what));
  member(text, "what_to_do", json::quotedText(words.what_to_do));
  member(text, "kind", json::quotedText(words.kind));
  member(text, "seen", json::numberText(report.fault.seen));
  member(text, "allowed", json::numberText(report.fault.allowed));
  member(text, "time", json::quotedText(isoTime(report.unix_time_s)));
  member(text, "tick", std::to_string(report.tick));
  member(text, "rate_hz", std::to_string(report.rate_hz));
  member(text, "device", device.text());
  member(text, "scheduling", scheduling.text());
  member(text, "late_ticks", lateText(report.late));
  member(text, "scene", scene::writeScene(scene::withoutFolders(report.scene)));
  while (text.back() == '\n') text.pop_back();  // of the scene's own file
  member(text, "columns", columns + "]");
  member(text, "rows", rowsText(report.last_second));
  return text + "\n}\n";
}

Problems writeFaultFile(std::string_view text, const std::string& path) {
  const std::string part = path + ".part";
  // Readable by its owner alone, as it says who felt what, and when.
  const int reason =
      system::putInPlace(system::makeNew(part, system::Existing::Replace), part, path, text, system::Lasting::Written);
  return reason == 0 ? Problems{} : cannotBeSaved(path, reason);
}

Result<std::string> saveFault(const servo::FaultReport& report, const FaultWords& words, const std::string& folder) {
  if (const int reason = system::makePrivateFolder(folder); reason != 0) return cannotBeSaved(folder, reason);
  std::string time = isoTime(report.unix_time_s);
  std::erase_if(time, [](char letter) { return letter == '-' || letter == ':'; });
  int number = 1;  // of the faults of that second
  for (const std::filesystem::path& one : faultsIn(folder)) {
    const std::string name = one.filename().string(), begin = std::string(kFileBegin) + time + "_";
    int taken = 0;
    if (name.starts_with(begin)) std::from_chars(name.data() + begin.size(), name.data() + name.size(), taken);
    number = std::min(std::max(number, taken + 1), kMaxInASecond);
  }
  const std::string file =
      std::string(kFileBegin) + time + "_" + twoDigits(number) + "_" + words.kind + std::string(kFileEnd);
  const std::filesystem::path path = std::filesystem::path(folder) / file;
  const Problems problems = writeFaultFile(faultText(report, words), path.string());
  if (!problems.empty()) return problems;
  removeOldest(folder, path);
  return path.string();
}

}  // namespace underact::record
