#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/base/translate.h"
#include "core/json/json.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
namespace {

constexpr const char* kOutside = TRANSLATE_NOOP("problem", "This must be from %1 to %2; here it is %3.");
constexpr const char* kNotWhole =
    TRANSLATE_NOOP("problem", "This must be a whole number from %1 to %2; here it is %3.");

/// A number for all axes, or one for each.
bool readAxes(const json::Value& value, const std::string& path, Vec3& into, Findings& findings) {
  if (value.kind == json::JsonKind::Number) {
    into.setConstant(value.number);
  } else if (value.kind == json::JsonKind::Array) {
    readNumber(value, path, into, findings);
  } else {
    return isKind(value, json::JsonKind::Number, path,
                  phrase(TRANSLATE_NOOP("problem", "a number, or a list of 3 numbers for x, y and z")), findings);
  }
  return true;
}

bool isSameNumber(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

bool isSameValue(const SettingValue& a, const SettingValue& b) {
  if (a.index() != b.index()) return false;
  if (const double* number = std::get_if<double>(&a)) return isSameNumber(*number, std::get<double>(b));
  const auto* const axes = std::get_if<Vec3>(&a);
  return axes != nullptr ? std::equal(axes->begin(), axes->end(), std::get<Vec3>(b).begin(), isSameNumber) : a == b;
}

bool readValue(const Setting& is, const json::Value& value, const std::string& path, SettingValue& into,
               Findings& findings) {
  if (is.kind == SettingKind::Gain) {
    Vec3 axes = Vec3::Zero();
    if (const auto* before = std::get_if<Vec3>(&into)) axes = *before;
    const bool is_good = readAxes(value, path, axes, findings);
    into = axes;
    return is_good;
  }
  if (is.kind == SettingKind::Choice) {
    const std::vector<std::string> words = is.words();
    into = value.text;
    if (value.kind == json::JsonKind::String && std::find(words.begin(), words.end(), value.text) != words.end())
      return true;
    json::refuseWord(value, path, words, findings);
    return false;
  }
  const bool is_flag = is.kind == SettingKind::Flag;
  const json::JsonKind kind = is_flag ? json::JsonKind::Bool : json::JsonKind::Number;
  into = is_flag ? SettingValue(value.boolean) : SettingValue(value.number);
  return isKind(value, kind, path, json::kindName(kind), findings);
}

Sentence rangeProblem(const Setting& is, double number) {
  const bool is_whole = is.kind == SettingKind::Whole;
  const bool is_inside = (is.is_above_min ? number > is.min : number >= is.min) && number <= is.max;
  if (is_inside && (!is_whole || number == std::floor(number))) return {};
  const char* const pattern = is.wrong != nullptr ? is.wrong : is_whole ? kNotWhole : kOutside;
  const int places = std::strstr(pattern, "%3") != nullptr ? 3 : std::strstr(pattern, "%2") != nullptr ? 2 : 1;
  const std::vector<Sentence> all{json::numberText(is.min), json::numberText(is.max), json::numberText(number)};
  return phrase(pattern, {all.end() - places, all.end()});
}

std::string fileTextOf(const SettingValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return json::numberText(*number);
  if (const auto* word = std::get_if<std::string>(&value)) return json::quotedText(*word);
  const auto* const axes = std::get_if<Vec3>(&value);
  if (axes == nullptr) return "null";
  const std::string x = json::numberText(axes->x());
  if (isSameValue(*axes, Vec3(Vec3::Constant(axes->x())))) return x;
  return "[" + x + ", " + json::numberText(axes->y()) + ", " + json::numberText(axes->z()) + "]";
}

}  // namespace underact::scene
