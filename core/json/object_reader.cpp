#include "core/json/object_reader.h"

#include <algorithm>
#include <tuple>

#include "core/base/translate.h"

namespace underact::json {
namespace {

constexpr std::size_t kMaxProblems = 100;
constexpr std::size_t kMaxNearest = 10;  // words that a nearest one is looked for: the costly part of a problem
constexpr const char* kMustBe = TRANSLATE_NOOP("problem", "This must be %1; here it is %2.");

}  // namespace

void Findings::add(const Value& value, const std::string& key, Sentence sentence) {
  add(std::pair{value.line, value.column}, key, std::move(sentence));
}

void Findings::add(std::pair<int, int> line_column, const std::string& key, Sentence sentence) {
  if (full()) {
    ++more_;
  } else {
    problems_.push_back({std::move(sentence), {file_, line_column.first, line_column.second, key}});
  }
}

void Findings::add(const Problems& problems) {
  for (const Problem& problem : problems) {
    const auto found = places_.find(problem.place.key);
    const std::pair<int, int> whole{problem.place.line, problem.place.column};
    add(found == places_.end() ? whole : found->second, problem.place.key, problem.sentence);
  }
}

bool Findings::full() const {
  return problems_.size() >= kMaxProblems;
}

std::string Findings::nearest(std::string_view word, const std::vector<std::string>& known) {
  if (full() || looked_ >= kMaxNearest) return {};
  ++looked_;
  return nearestWord(word, known);
}

Problems Findings::take() {
  std::stable_sort(problems_.begin(), problems_.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  if (more_ > 0) {
    problems_.push_back({phrase(TRANSLATE_NOOP("problem", "The file has %1 more problems."), {std::to_string(more_)}),
                         problems_.back().place});
  }
  return std::move(problems_);
}

ObjectReader::ObjectReader(const Value& object, std::string path, Sentence what, Findings& findings)
    : object_(object),
      path_(std::move(path)),
      what_(std::move(what)),
      findings_(findings),
      asked_(object.keys.size(), false) {
  for (std::size_t index = 0; index < object.keys.size(); ++index) first_of_.emplace(object.keys[index], index);
}

const Value* ObjectReader::find(const char* key, bool required) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  if (const auto found = first_of_.find(key); found != first_of_.end()) {
    const Value& value = object_.items[found->second];
    asked_[found->second] = true;
    findings_.remember(pathOf(key), value);
    return &value;
  }
  if (required)
    findings_.add(object_, pathOf(key),
                  phrase(TRANSLATE_NOOP("problem", "The key \"%1\" is missing; %2 needs it."), {key, what_}));
  return nullptr;
}

void ObjectReader::finish(bool all_known) {
  for (std::size_t index = 0; index < object_.keys.size(); ++index) {
    const std::string& key = object_.keys[index];
    const std::size_t first = first_of_.at(key);
    if (first == index) {
      judge(index, all_known);
    } else if (findings_.full()) {
      findings_.add(object_, {}, {});
    } else {
      findings_.add(
          object_.key_places[index], pathOf(plainKey(key)),
          phrase(TRANSLATE_NOOP("problem",
                                "The key %1 appears a second time; the first is on line %2. Remove one of them."),
                 {shown(key), std::to_string(object_.key_places[first].first)}));
    }
  }
}

void ObjectReader::judge(std::size_t index, bool all_known) {
  if (asked_[index]) return;
  const std::string& key = object_.keys[index];
  const auto refused = refused_.find(key);
  if (refused == refused_.end() && !all_known) return;
  const std::pair<int, int>& place = object_.key_places[index];
  if (findings_.full()) return findings_.add(place, {}, {});  // counted: its words would cost more than the rest
  const std::string path = pathOf(plainKey(key));
  if (refused != refused_.end()) return findings_.add(place, path, refused->second);
  const std::string nearest = findings_.nearest(key, known_);
  findings_.add(place, path,
                nearest.empty()
                    ? phrase(TRANSLATE_NOOP("problem", "The key %1 is not known in %2. Known keys: %3."),
                             {shown(key), what_, listed(known_, "and")})
                    : phrase(TRANSLATE_NOOP("problem", "The key %1 is not known in %2. Did you mean \"%3\"?"),
                             {shown(key), what_, nearest}));
}

void ObjectReader::refuseLater(const std::vector<std::string>& keys) {
  for (const std::string& key : keys) refuse(key, notYet("\"" + key + "\""));
}

Sentence kindName(JsonKind kind) {
  switch (kind) {
    case JsonKind::Null:
      return "null";
    case JsonKind::Bool:
      return phrase(TRANSLATE_NOOP("problem", "true or false"));
    case JsonKind::Number:
      return phrase(TRANSLATE_NOOP("problem", "a number"));
    case JsonKind::String:
      return phrase(TRANSLATE_NOOP("problem", "text"));
    case JsonKind::Array:
      return phrase(TRANSLATE_NOOP("problem", "a list"));
    case JsonKind::Object:
      return phrase(TRANSLATE_NOOP("problem", "an object in { }"));
  }
  return "null";
}

Sentence notYet(const std::string& what) {
  return phrase(TRANSLATE_NOOP("problem", "%1 is not in this version of Underact."), {what});
}

bool isKind(const Value& value, JsonKind kind, const std::string& path, const Sentence& expected, Findings& findings) {
  if (value.kind == kind) return true;
  findings.add(value, path, phrase(kMustBe, {expected, kindName(value.kind)}));
  return false;
}

void refuseWord(const Value& value, const std::string& path, const std::vector<std::string>& words,
                Findings& findings) {
  const Sentence expected = listed(words);
  if (isKind(value, JsonKind::String, path, expected, findings))
    findings.add(value, path, phrase(kMustBe, {expected, shown(value.text)}));
}

namespace {

/// A list of three; the path of the element at index is path[index].
bool isTriple(const Value& value, const std::string& path, const Sentence& expected, Findings& findings) {
  if (!isKind(value, JsonKind::Array, path, expected, findings)) return false;
  if (value.items.size() == 3) return true;
  findings.add(value, path,
               phrase(TRANSLATE_NOOP("problem", "This must be %1; here it has %2."),
                      {expected, std::to_string(value.items.size())}));
  return false;
}

std::string elementOf(const std::string& path, Eigen::Index index) {
  return path + "[" + std::to_string(index) + "]";
}

bool readThree(const Value& list, const std::string& path, Vec3& into, Findings& findings) {
  into.setOnes();
  bool all = true;
  for (Eigen::Index index = 0; index < 3; ++index) {
    const Value& item = list.items[static_cast<std::size_t>(index)];
    const std::string item_path = elementOf(path, index);
    findings.remember(item_path, item);
    if (isKind(item, JsonKind::Number, item_path, kindName(JsonKind::Number), findings)) {
      into[index] = item.number;
    } else {
      all = false;
    }
  }
  return all;
}

}  // namespace

void readNumber(const Value& value, const std::string& path, double& into, Findings& findings) {
  if (isKind(value, JsonKind::Number, path, kindName(JsonKind::Number), findings)) into = value.number;
}

void readNumber(const Value& value, const std::string& path, Vec3& into, Findings& findings) {
  if (isTriple(value, path, phrase(TRANSLATE_NOOP("problem", "a list of 3 numbers, as in [0, 30, 0]")), findings)) {
    readThree(value, path, into, findings);
  }
}

void readNumber(const Value& value, const std::string& path, Mat3& into, Findings& findings) {
  const Sentence expected =
      phrase(TRANSLATE_NOOP("problem", "a list of 3 rows, as in [[1, 0, 0], [0, 1, 0], [0, 0, 1]]"));
  if (!isTriple(value, path, expected, findings)) return;
  Mat3 read = Mat3::Identity();
  bool all = true;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const Value& item = value.items[static_cast<std::size_t>(row)];
    const std::string row_path = elementOf(path, row);
    Vec3 numbers = Vec3::Zero();
    findings.remember(row_path, item);
    all &= isTriple(item, row_path, phrase(TRANSLATE_NOOP("problem", "a row of 3 numbers")), findings) &&
           readThree(item, row_path, numbers, findings);
    read.row(row) = numbers.transpose();
  }
  if (all) into = read;
}

void readText(const Value& value, const std::string& path, std::string& into, Findings& findings) {
  if (isKind(value, JsonKind::String, path, phrase(TRANSLATE_NOOP("problem", "text in double quotes")), findings))
    into = value.text;
}

}  // namespace underact::json
