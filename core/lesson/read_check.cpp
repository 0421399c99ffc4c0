#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/translate.h"
#include "core/lesson/read.h"
#include "core/lesson/read_parts.h"

namespace underact::lesson {
namespace {

using json::Value;

/// A finite number, at least `least`; empty: there is none, or it is a problem.
std::optional<double> readAmount(ObjectReader& object, const char* key, bool required, double min = -kInfinity) {
  const Value* const value = object.find(key, required);
  if (value == nullptr) return {};
  const std::string path = object.pathOf(key);
  double number = kNotANumber;
  readNumber(*value, path, number, object.findings());
  if (value->kind != json::JsonKind::Number) return {};
  if (!std::isfinite(number)) {
    object.findings().add(*value, path, phrase(TRANSLATE_NOOP("problem", "This is not a finite number.")));
  } else if (number < min) {
    object.findings().add(*value, path,
                          phrase(TRANSLATE_NOOP("problem", "This must be at least %1."), {json::numberText(min)}));
  } else {
    return number;
  }
  return {};
}

std::vector<std::string> quantityKeys() {
  std::vector<std::string> keys;
  for (const Quantity& quantity : quantities()) keys.emplace_back(quantity.key);
  return keys;
}

Measure readMeasure(ObjectReader& object, bool required) {
  Measure measure;
  if (const Value* const value = object.find("measure", required)) {
    measure.quantity = findQuantity(readName(*value, object.pathOf("measure"), quantityKeys(),
                                             phrase(TRANSLATE_NOOP("problem", "quantity")), object.findings()));
  }
  const std::optional<double> part = readAmount(object, "part", false, 1.0);
  if (!part || measure.quantity == nullptr) return measure;
  const auto parts = static_cast<double>(measure.quantity->parts);
  if (*part > parts || *part != std::floor(*part)) {
    object.findings().add(*object.find("part"), object.pathOf("part"),
                          phrase(TRANSLATE_NOOP("problem", "The quantity %1 has the parts 1 to %2."),
                                 {std::string(measure.quantity->key), json::numberText(parts)}));
    return measure;
  }
  measure.part = static_cast<std::size_t>(*part);
  return measure;
}

bool isOneNumber(const Measure& measure) {
  return measure.quantity == nullptr || measure.part > 0 || measure.quantity->parts == 1;
}

/// A number, or a list of as many as the measure has values; null in it: any value.
std::vector<double> readPlace(const Value& value, const std::string& path, const Measure& measure, Findings& findings) {
  if (measure.quantity == nullptr) return {0.0};  // said already
  if (isOneNumber(measure)) {
    if (!isKind(value, json::JsonKind::Number, path, "a number", findings)) return {0.0};
    if (!std::isfinite(value.number))
      findings.add(value, path, phrase(TRANSLATE_NOOP("problem", "This is not a finite number.")));
    return {value.number};
  }
  const std::size_t parts = measure.quantity->parts;
  const bool may_be_fewer = measure.quantity->needs == Needs::Robot;  // a robot may have fewer joints
  constexpr std::size_t kDefaultJoints = 6;                           // more may follow, of an arm that has them
  const std::size_t fewest = may_be_fewer ? 1 : std::min(parts, kDefaultJoints);
  const std::string count = std::to_string(may_be_fewer ? parts : fewest);
  const Sentence expected = phrase(TRANSLATE_NOOP("problem", "a list of %1 numbers"), {count});
  if (!isKind(value, json::JsonKind::Array, path, expected, findings)) return {0.0};
  if (value.items.size() > parts || value.items.size() < fewest)
    findings.add(value, path,
                 phrase(TRANSLATE_NOOP("problem", "This must be %1; here it has %2."),
                        {expected, std::to_string(value.items.size())}));
  std::vector<double> place;
  for (const Value& item : value.items) {
    const bool is_whichever = item.kind == json::JsonKind::Null && measure.quantity->apart != DistanceMetric::Angle;
    if (!is_whichever)
      isKind(item, json::JsonKind::Number, path, phrase(TRANSLATE_NOOP("problem", "a number, or null for any value")),
             findings);
    if (item.kind == json::JsonKind::Number && !std::isfinite(item.number))
      findings.add(item, path, phrase(TRANSLATE_NOOP("problem", "This is not a finite number.")));
    place.push_back(item.kind == json::JsonKind::Number ? item.number : kNotANumber);
  }
  if (may_be_fewer) place.resize(parts, kNotANumber);
  return place;
}

/// above, below, near and within.
Criterion readWanted(ObjectReader& object, const Value& whole) {
  Criterion wanted;
  wanted.measure = readMeasure(object, true);
  const std::optional<double> above = readAmount(object, "above", false), below = readAmount(object, "below", false);
  const Value* const near = object.find("near");
  const std::optional<double> within = readAmount(object, "within", near != nullptr, 0.0);
  wanted.above = above.value_or(-kInfinity), wanted.below = below.value_or(kInfinity);
  wanted.within = within.value_or(0.0);
  if (near != nullptr) wanted.near = readPlace(*near, object.pathOf("near"), wanted.measure, object.findings());
  const bool is_band = object.find("above") != nullptr || object.find("below") != nullptr;
  if (is_band == (near != nullptr)) {
    object.findings().add(
        whole, object.pathOf("measure"),
        phrase(TRANSLATE_NOOP("problem",
                              "Give a range (\"above\", \"below\" or both), or a value (\"near\" with \"within\").")));
  } else if (wanted.above >= wanted.below) {
    object.findings().add(whole, object.pathOf("above"),
                          phrase(TRANSLATE_NOOP("problem", "\"above\" must be less than \"below\".")));
  }
  return wanted;
}

std::vector<Criterion> readMeanwhile(ObjectReader& object) {
  std::vector<Criterion> all;
  const Value* const list = object.find("while");
  const std::string path = object.pathOf("while");
  if (list == nullptr || !isKind(*list, json::JsonKind::Array, path,
                                 phrase(TRANSLATE_NOOP("problem", "a list of conditions")), object.findings()))
    return all;
  for (std::size_t index = 0; index < std::min(list->items.size(), kMaxChecks); ++index) {
    const std::string at = path + "[" + std::to_string(index) + "]";
    if (!isKind(list->items[index], json::JsonKind::Object, at, phrase(TRANSLATE_NOOP("problem", "a condition in { }")),
                object.findings()))
      continue;
    ObjectReader condition(list->items[index], at, phrase(TRANSLATE_NOOP("problem", "a condition")), object.findings());
    all.push_back(readWanted(condition, list->items[index]));
    condition.finish();
  }
  return all;
}

Visit readVisit(ObjectReader& object) {
  Visit visit{readMeasure(object, true), {}, readAmount(object, "within", true, 0.0).value_or(0.0)};
  const Value& list = *object.find("visit");
  const std::string path = object.pathOf("visit");
  if (!isKind(list, json::JsonKind::Array, path, phrase(TRANSLATE_NOOP("problem", "a list of values")),
              object.findings()))
    return visit;
  if (list.items.empty() || list.items.size() > kMaxPlaces)
    object.findings().add(list, path,
                          phrase(TRANSLATE_NOOP("problem", "Give 1 to %1 values."), {std::to_string(kMaxPlaces)}));
  for (std::size_t index = 0; index < std::min(list.items.size(), kMaxPlaces); ++index) {
    const std::string at = path + "[" + std::to_string(index) + "]";
    visit.places.push_back(readPlace(list.items[index], at, visit.measure, object.findings()));
  }
  return visit;
}

/// A measure that is a single number, for comparisons.
Measure readOneNumber(ObjectReader& object, const Value& whole) {
  Measure measure = readMeasure(object, true);
  if (!isOneNumber(measure)) {
    object.findings().add(
        whole, object.pathOf("part"),
        phrase(TRANSLATE_NOOP("problem", "The quantity %1 has %2 values here; choose one with \"part\"."),
               {std::string(measure.quantity->key), std::to_string(measure.quantity->parts)}));
    measure.part = 1;
  }
  return measure;
}

Cross readCross(ObjectReader& object, const Value& whole) {
  Cross cross;
  cross.measure = readOneNumber(object, whole);
  cross.value = readAmount(object, "crosses", true).value_or(0.0);
  cross.by = readAmount(object, "by", false, 0.0).value_or(0.0);
  cross.times = static_cast<int>(std::min(readAmount(object, "times", true, 1.0).value_or(1.0), 1e6));
  cross.in_s = readAmount(object, "in_s", true, 0.0).value_or(1.0);
  return cross;
}

AskNumber readNumberQuestion(ObjectReader& object, const Value& whole) {
  AskNumber ask;
  ask.question = readLine(object, "question", true);
  const bool is_measured = object.find("measure") != nullptr;
  ask.within = readAmount(object, "within", true, 0.0).value_or(0.0);
  ask.answer = readAmount(object, "answer", !is_measured).value_or(kNotANumber);
  if (is_measured) ask.measure = readOneNumber(object, whole);
  if (is_measured && object.find("answer") != nullptr)
    object.findings().add(
        whole, object.pathOf("answer"),
        phrase(TRANSLATE_NOOP("problem", "The answer is either measured or given: remove \"measure\" or \"answer\".")));
  if (const Value* const unit = object.find("unit"))
    readText(*unit, object.pathOf("unit"), ask.unit, object.findings());
  if (ask.unit.empty() && ask.measure.quantity != nullptr) ask.unit = ask.measure.quantity->unit;
  return ask;
}

AskChoice readChoiceQuestion(ObjectReader& object) {
  AskChoice ask;
  ask.question = readLine(object, "question", true);
  const Value& list = *object.find("choices");
  const std::string path = object.pathOf("choices");
  if (isKind(list, json::JsonKind::Array, path, phrase(TRANSLATE_NOOP("problem", "a list of answers")),
             object.findings())) {
    if (list.items.size() < 2 || list.items.size() > 9)
      object.findings().add(list, path, phrase(TRANSLATE_NOOP("problem", "Give 2 to 9 answers to choose from.")));
    for (std::size_t index = 0; index < list.items.size(); ++index) {
      ask.choices.emplace_back();
      readText(list.items[index], path + "[" + std::to_string(index) + "]", ask.choices.back(), object.findings());
    }
  }
  const std::optional<double> read = readAmount(object, "right", true, 1.0);
  const double right = read.value_or(1.0);
  if (!read) return ask;  // said already
  if (right > static_cast<double>(ask.choices.size()) || right != std::floor(right)) {
    object.findings().add(*object.find("right"), object.pathOf("right"),
                          phrase(TRANSLATE_NOOP("problem", "This must be the number of the right answer, 1 to %1."),
                                 {std::to_string(ask.choices.size())}));
  } else {
    ask.right = static_cast<std::size_t>(right);
  }
  return ask;
}

/// Whether a misconception can be shown by this answer.
bool isWrongAnswer(const Task& task, double answer) {
  if (const auto* choice = std::get_if<AskChoice>(&task))
    return answer >= 1.0 && answer <= static_cast<double>(choice->choices.size()) && answer == std::floor(answer) &&
           answer != static_cast<double>(choice->right);
  const auto* number = std::get_if<AskNumber>(&task);
  return number == nullptr || !(std::abs(answer - number->answer) <= number->within);
}

std::vector<Misconception> readMisconceptions(ObjectReader& object, const Task& task) {
  std::vector<Misconception> all;
  const Value* const list = object.find("misconceptions");
  const std::string path = object.pathOf("misconceptions");
  if (list == nullptr || !isKind(*list, json::JsonKind::Array, path,
                                 phrase(TRANSLATE_NOOP("problem", "a list of misconceptions")), object.findings()))
    return all;
  for (std::size_t index = 0; index < std::min(list->items.size(), kMaxChecks); ++index) {
    const std::string at = path + "[" + std::to_string(index) + "]";
    const Sentence what = phrase(TRANSLATE_NOOP("problem", "a misconception"));
    if (!isKind(list->items[index], json::JsonKind::Object, at, what, object.findings())) continue;
    ObjectReader one(list->items[index], at, what, object.findings());
    const std::optional<double> answer = readAmount(one, "answer", true);
    if (answer && !isWrongAnswer(task, *answer))
      object.findings().add(list->items[index], one.pathOf("answer"),
                            phrase(TRANSLATE_NOOP("problem", "This must be a wrong answer to the question.")));
    all.push_back({answer.value_or(kNotANumber), readLine(one, "name", true)});
    one.finish();
  }
  return all;
}

/// The kind of a check follows from a key that only this kind has.
Task readTask(ObjectReader& object, const Value& value) {
  if (value.find("choices") != nullptr) return readChoiceQuestion(object);
  if (value.find("question") != nullptr) return readNumberQuestion(object, value);
  if (value.find("visit") != nullptr) return readVisit(object);
  if (value.find("spans") != nullptr)
    return Span{readOneNumber(object, value), readAmount(object, "spans", true, 0.0).value_or(0.0)};
  if (value.find("crosses") != nullptr) return readCross(object, value);
  Hold hold{readWanted(object, value), readAmount(object, "for_s", false, 0.0).value_or(0.0)};
  return hold;
}

}  // namespace

Check readCheck(const Value& value, const std::string& path, Findings& findings) {
  Check check{Hold{}, {}, {}, {}, {findings.file(), value.line, value.column, path}};
  if (!isKind(value, json::JsonKind::Object, path, phrase(TRANSLATE_NOOP("problem", "a check in { }")), findings))
    return check;
  ObjectReader object(value, path, phrase(TRANSLATE_NOOP("problem", "a check")), findings);
  check.task = readTask(object, value);
  check.meanwhile = readMeanwhile(object);
  if (questionOf(check) != nullptr) check.misconceptions = readMisconceptions(object, check.task);
  if (const Value* const say = object.find("say")) readText(*say, object.pathOf("say"), check.say, findings);
  object.finish();
  return check;
}

}  // namespace underact::lesson
