#include "core/arm/urdf_words.h"

#include <tinyxml2.h>

#include <algorithm>
#include <utility>

#include "core/base/translate.h"
#include "core/json/text.h"

namespace underact::arm {
namespace {

constexpr std::size_t kMaxUrdfProblems = 100;

}  // namespace

Problem problemAt(const std::string& file, int line, const std::string& key, Sentence sentence) {
  return {std::move(sentence), {file, line, 0, key}};
}

void UrdfWords::checkAll(const XMLElement& element, const std::vector<std::string>& known) {
  checkAttributes(element, known);
  for (const tinyxml2::XMLAttribute* one = element.FirstAttribute(); one != nullptr; one = one->Next()) {
    const std::string word = one->Name();
    if (word.find(':') != std::string::npos || !json::nearestWord(word, known).empty()) continue;
    say(element, json::plainKey(word),
        phrase(TRANSLATE_NOOP("problem", "The attribute %1 is not known in <%2>, and may move the link."),
               {json::shown(word), std::string(element.Name())}));
  }
  for (const XMLElement* one = element.FirstChildElement(); one != nullptr; one = one->NextSiblingElement())
    say(*one, json::plainKey(one->Name()),
        phrase(TRANSLATE_NOOP("problem", "The element %1 is not known in <%2>, and may move the link."),
               {json::shown(one->Name()), std::string(element.Name())}));
}

const XMLElement* UrdfWords::only(const XMLElement& parent, const char* name) {
  const XMLElement* const first = parent.FirstChildElement(name);
  if (first == nullptr) return first;
  if (const XMLElement* const second = first->NextSiblingElement(name))
    say(*second, name,
        phrase(TRANSLATE_NOOP("problem", "The element <%1> appears twice in <%2>."),
               {name, std::string(parent.Name())}));
  return first;
}

void UrdfWords::say(const XMLElement& at, const std::string& key, Sentence sentence) {
  if (into_->size() < kMaxUrdfProblems) into_->push_back(problemAt(file_, at.GetLineNum(), key, std::move(sentence)));
}

void UrdfWords::checkWord(const XMLElement& element, const std::vector<std::string>& known) {
  if (into_->size() >= kMaxUrdfProblems) return;
  const std::string word = element.Name(), nearest = json::nearestWord(word, known);
  if (nearest.empty() || nearest == word) return;
  say(element, json::plainKey(word),
      phrase(TRANSLATE_NOOP("problem", "The element %1 is not known here. Did you mean \"%2\"?"),
             {json::shown(word), nearest}));
}

void UrdfWords::checkAttributes(const XMLElement& element, const std::vector<std::string>& known) {
  for (const tinyxml2::XMLAttribute* one = element.FirstAttribute(); one != nullptr; one = one->Next()) {
    const std::string word = one->Name(), nearest = json::nearestWord(word, known);
    if (nearest.empty() || nearest == word || into_->size() >= kMaxUrdfProblems) continue;
    into_->push_back(
        problemAt(file_, one->GetLineNum(), json::plainKey(word),
                  phrase(TRANSLATE_NOOP("problem", "The attribute %1 is not known in <%2>. Did you mean \"%3\"?"),
                         {json::shown(word), std::string(element.Name()), nearest})));
  }
}

std::string UrdfWords::attribute(const XMLElement& element, const char* key, const char* what) {
  const char* const text = element.Attribute(key);
  if (text != nullptr && *text != '\0') return text;
  say(element, key,
      phrase(TRANSLATE_NOOP("problem", "The attribute \"%1\" is missing; %2 needs it."),
             {key, "<" + std::string(what) + ">"}));
  return {};
}

bool UrdfWords::numbers(const XMLElement& element, const char* key, const char* text, std::span<double> into) {
  std::string_view rest = text;
  std::vector<double> read;
  const auto skip = [&] {
    while (!rest.empty() && std::string_view(" \t\r\n").find(rest.front()) != std::string_view::npos)
      rest.remove_prefix(1);
  };
  for (skip(); !rest.empty() && read.size() <= into.size(); skip()) {
    const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
    std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end);
    if (word.starts_with('+')) word.remove_prefix(1);
    const std::optional<double> number = json::wholeNumber(word);
    if (!number) break;
    read.push_back(*number);
  }
  if (read.size() == into.size() && rest.empty()) {
    std::copy(read.begin(), read.end(), into.begin());
    return true;
  }
  const std::string count = std::to_string(into.size());
  say(element, key,
      into.size() == 1
          ? phrase(TRANSLATE_NOOP("problem", "This must be a finite number; here it is %1."), {json::shown(text)})
          : phrase(TRANSLATE_NOOP("problem", "This must be %1 finite numbers; here it is %2."),
                   {count, json::shown(text)}));
  return false;
}

bool UrdfWords::three(const XMLElement& element, const char* key, Vec3& into) {
  const char* const text = element.Attribute(key);
  return text == nullptr || numbers(element, key, text, {into.data(), 3});
}

double UrdfWords::one(const XMLElement& element, const char* key, double otherwise) {
  double number = otherwise;
  if (const char* const text = element.Attribute(key)) numbers(element, key, text, {&number, 1});
  return number;
}

}  // namespace underact::arm
