#include "core/sweep/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "core/json/json.h"
#include "core/json/text.h"

namespace underact::sweep {
namespace {

/// The whole text as a number; none: it is not one.
template <class Number>
std::optional<Number> whole(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

std::optional<double> finite(std::string_view text) {
  const std::optional<double> value = whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

Problem problemWith(const std::string& name, const std::string& sentence) {
  return {"--" + name + ": " + sentence};
}

std::string between(double low, double high) {
  return "from " + json::numberText(low) + " to " + json::numberText(high);
}

}  // namespace

Result<Options> Options::from(const std::vector<Option>& rows, const Values& given) {
  Options options;
  Problems problems;
  std::vector<std::string> names;
  for (const Option& row : rows) {
    names.push_back(row.name);
    const auto found = given.find(row.name);
    options.values_[row.name] = found == given.end() ? row.default_value : found->second;
    const std::size_t count = options.values_[row.name].size();
    if (count == 0) problems.push_back(problemWith(row.name, "A value is missing. " + row.what + "."));
    if (count > 1 && !row.many) problems.push_back(problemWith(row.name, "It takes one value, but has several here."));
  }
  for (const auto& [name, values] : given) {
    if (options.values_.contains(name)) continue;
    const std::string near = json::nearestWord(name, names);
    problems.push_back(
        problemWith(name, "There is no such option." + (near.empty() ? "" : " Did you mean --" + near + "?")));
  }
  if (!problems.empty()) return problems;
  return options;
}

const std::vector<std::string>& Options::texts(const std::string& name) const {
  return values_.at(name);
}

std::vector<double> Options::numbers(const std::string& name, double low, double high) {
  std::vector<double> numbers;
  for (const std::string& text : texts(name)) {
    const std::optional<double> value = finite(text);
    if (!value || *value < low || *value > high)
      note(name, "It must be a number " + between(low, high) + "; here it is " + json::shown(text) + ".");
    numbers.push_back(value.value_or(low));
  }
  return numbers;
}

double Options::number(const std::string& name, double low, double high) {
  return numbers(name, low, high).front();
}

std::vector<std::int64_t> Options::integers(const std::string& name, std::int64_t low, std::int64_t high) {
  std::vector<std::int64_t> integers;
  for (const std::string& text : texts(name)) {
    const std::optional<std::int64_t> value = whole<std::int64_t>(text);
    if (!value || *value < low || *value > high)
      note(name, "It must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
                     "; here it is " + json::shown(text) + ".");
    integers.push_back(std::clamp(value.value_or(low), low, high));
  }
  return integers;
}

std::int64_t Options::integer(const std::string& name, std::int64_t low, std::int64_t high) {
  return integers(name, low, high).front();
}

Range Options::range(const std::string& name, double low, double high) {
  const std::string& given = text(name);
  const std::size_t colon = given.find(':');
  const std::optional<double> first = finite(given.substr(0, colon));
  const std::optional<double> last = colon == std::string::npos ? first : finite(given.substr(colon + 1));
  if (first && last && low <= *first && *first <= *last && *last <= high) return {*first, *last};
  note(name,
       "It must be a number, or two as LOW:HIGH, " + between(low, high) + "; here it is " + json::shown(given) + ".");
  return {low, low};
}

std::size_t Options::choice(const std::string& name, const std::vector<std::string>& words) {
  const auto found = std::find(words.begin(), words.end(), text(name));
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  note(name, "It must be " + json::listed(words) + "; here it is " + json::shown(text(name)) + ".");
  return 0;
}

void Options::note(const std::string& name, const std::string& sentence) {
  problems_.push_back(problemWith(name, sentence));
}

std::string Options::canonical() const {
  std::string text;
  for (const auto& [name, values] : values_) {
    std::string list;
    for (const std::string& value : values) list += (list.empty() ? "" : ", ") + json::quotedText(value);
    text += (text.empty() ? "" : ", ") + json::quotedText(name) + ": [" + list + "]";
  }
  return "{" + text + "}";
}

}  // namespace underact::sweep
