#include "core/lesson/report.h"

#include <cmath>

#include "core/base/translate.h"
#include "core/json/object_text.h"
#include "core/lesson/read.h"
#include "core/lesson/read_parts.h"

namespace underact::lesson {
namespace {

constexpr std::string_view kBegin = "<script type=\"application/json\" id=\"underact-report\">", kEnd = "</script>";
constexpr std::size_t kLongestText = 400;        // bytes; the window's own are shorter
constexpr std::size_t kMaxMisconceptions = 100;  // of a step; further ones do not change which is the most frequent

/// A longer text is a problem.
std::string shortText(const json::Value& value, const std::string& path, Findings& findings) {
  std::string text;
  readText(value, path, text, findings);
  if (text.size() > kLongestText)
    findings.add(value, path,
                 phrase(TRANSLATE_NOOP("problem", "This is longer than %1 bytes."), {std::to_string(kLongestText)}));
  return text;
}

std::string readShort(ObjectReader& object, const char* key) {
  const json::Value* const value = object.find(key, true);
  return value == nullptr ? std::string() : shortText(*value, object.pathOf(key), object.findings());
}

double readBounded(ObjectReader& object, const char* key, bool is_count) {
  constexpr double kMax = 1e6;
  double number = 0.0;
  const json::Value* const value = object.find(key, true);
  if (value == nullptr) return number;
  readNumber(*value, object.pathOf(key), number, object.findings());
  if (number >= 0.0 && number <= kMax && (!is_count || number == std::floor(number))) return number;
  object.findings().add(*value, object.pathOf(key),
                        phrase(TRANSLATE_NOOP("problem", "This must be from 0 to %1."), {shownNumber(kMax, 0)}));
  return 0.0;
}

StepReport readStepReport(const json::Value& value, const std::string& path, Findings& findings) {
  StepReport step;
  const Sentence what = phrase(TRANSLATE_NOOP("problem", "a step in { }"));
  if (!isKind(value, json::JsonKind::Object, path, what, findings)) return step;
  ObjectReader object(value, path, phrase(TRANSLATE_NOOP("problem", "a step")), findings);
  step.title = readShort(object, "title");
  const json::Value* const solved = object.find("solved", true);
  if (solved != nullptr && isKind(*solved, json::JsonKind::Bool, object.pathOf("solved"),
                                  phrase(TRANSLATE_NOOP("problem", "true or false")), findings))
    step.solved = solved->boolean;
  step.attempts = static_cast<std::size_t>(readBounded(object, "attempts", true));
  step.wrong = static_cast<std::size_t>(readBounded(object, "wrong", true));
  const json::Value* const names = object.find("misconceptions", true);
  if (names != nullptr && isKind(*names, json::JsonKind::Array, object.pathOf("misconceptions"),
                                 phrase(TRANSLATE_NOOP("problem", "a list of names")), findings)) {
    for (const json::Value& name : names->items) {
      if (step.misconceptions.size() == kMaxMisconceptions) break;
      step.misconceptions.push_back(shortText(name, object.pathOf("misconceptions"), findings));
    }
  }
  object.finish();
  return step;
}

Report readRoot(const json::Value& root, Findings& findings) {
  ObjectReader object(root, "", phrase(TRANSLATE_NOOP("problem", "a report")), findings);
  if (readBounded(object, "underact_report", true) != 1.0)
    findings.add(root, "underact_report",
                 phrase(TRANSLATE_NOOP("problem", "This must be the number 1, the version of reports.")));
  Report report{readShort(object, "student"), readShort(object, "lesson"),           readShort(object, "title"),
                readShort(object, "date"),    readBounded(object, "minutes", false), {}};
  const json::Value* const steps = object.find("steps", true);
  if (steps != nullptr &&
      isKind(*steps, json::JsonKind::Array, "steps", phrase(TRANSLATE_NOOP("problem", "a list of steps")), findings)) {
    if (steps->items.empty() || steps->items.size() > kMaxSteps)
      findings.add(*steps, "steps",
                   phrase(TRANSLATE_NOOP("problem", "A lesson has 1 to %1 steps."), {std::to_string(kMaxSteps)}));
    for (std::size_t index = 0; index < std::min(steps->items.size(), kMaxSteps); ++index)
      report.steps.push_back(readStepReport(steps->items[index], "steps[" + std::to_string(index) + "]", findings));
  }
  object.finish();
  return report;
}

}  // namespace

StepReport reportOf(const Step& step, bool solved, const std::vector<CheckState>& states) {
  StepReport report{step.title, solved, 0, 0, {}};
  for (std::size_t index = 0; index < std::min(states.size(), step.checks.size()); ++index) {
    const Check& check = step.checks[index];
    const CheckState& state = states[index];
    report.attempts += state.wrong.size() + (state.solved && state.answer ? 1 : 0);
    report.wrong += state.wrong.size();
    for (const double answer : state.wrong) {
      const Misconception* const shown = misconceptionOf(check, answer);
      if (shown != nullptr && report.misconceptions.size() < kMaxMisconceptions)
        report.misconceptions.push_back(shown->name);
    }
  }
  return report;
}

std::string reportData(const Report& report) {
  json::ObjectText object;
  object.addInteger("underact_report", 1);
  object.addText("student", report.student);
  object.addText("lesson", report.lesson);
  object.addText("title", report.title);
  object.addText("date", report.date);
  object.addNumber("minutes", report.minutes);
  std::vector<json::ObjectText> steps;
  for (const StepReport& step : report.steps) {
    json::ObjectText& one = steps.emplace_back();
    one.addText("title", step.title);
    one.addBool("solved", step.solved);
    one.addInteger("attempts", step.attempts);
    one.addInteger("wrong", step.wrong);
    one.addTexts("misconceptions", step.misconceptions);
  }
  object.addList("steps", steps);
  std::string text(kBegin);
  for (const char letter : object.text()) text += letter == '<' ? std::string("\\u003c") : std::string(1, letter);
  return text + std::string(kEnd);
}

Result<Report> readReport(std::string_view page, const std::string& file_name) {
  const std::size_t begin = page.find(kBegin);
  const std::size_t end = begin == std::string_view::npos ? begin : page.find(kEnd, begin);
  if (end == std::string_view::npos)
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "This page is no report of a lesson, or one of an earlier version, which "
                                           "has no data for a table.")),
                     {file_name}}};
  const Result<json::Value> root =
      json::parse(page.substr(begin + kBegin.size(), end - begin - kBegin.size()), file_name);
  if (!root) return root.problems();
  Findings findings(file_name);
  if (!isKind(root.value(), json::JsonKind::Object, "", phrase(TRANSLATE_NOOP("problem", "an object in { }")),
              findings))
    return findings.take();
  Report report = readRoot(root.value(), findings);
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return report;
}

}  // namespace underact::lesson
