#pragma once
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/scene/rules.h"
#include "core/scene/setting_rows.h"

namespace underact::scene::row {

// Internal to the room: makes a row of the table from a member of an object of the description.

/// The object that a pointer to a member belongs to.
template <class Member>
struct MemberOf;
/// Of a member of any type.
template <class Its, class Type>
struct MemberOf<Type Its::*> {
  using Object = Its;  // the class
};
/// Makes it from the member pointer itself.
template <auto kMember>
using ObjectOf = typename MemberOf<decltype(kMember)>::Object;

template <class Object>
constexpr const char* kObject = "/constraints/*";  // a shape's own keys are among the constraint's
template <>
constexpr const char* kObject<Description> = "";
template <>
constexpr const char* kObject<Simulation> = "/simulation";
template <>
constexpr const char* kObject<Control> = "/control";
template <>
constexpr const char* kObject<Velocity> = "/control/velocity";
template <>
constexpr const char* kObject<Influence> = "/constraints/*/influence";
template <>
constexpr const char* kObject<Friction> = "/constraints/*/friction";
template <>
constexpr const char* kObject<CurveGuidance> = "/constraints/*/guide";
template <>
constexpr const char* kObject<Solver> = "/constraints/*/solver";
template <>
constexpr const char* kObject<Joint> = "/constraints/*/joints/*";

// The value of a member, and a value into a member. The value is of the member's kind: std::get throws otherwise.
/// A number.
inline SettingValue valueOf(double number) {
  return number;
}
/// A whole number, as a double.
inline SettingValue valueOf(int number) {
  return static_cast<double>(number);
}
/// A flag.
inline SettingValue valueOf(bool flag) {
  return flag;
}
/// A number for each axis.
inline SettingValue valueOf(const Vec3& axes) {
  return axes;
}
/// A number, or none.
inline SettingValue valueOf(const std::optional<double>& number) {
  return number ? SettingValue(*number) : SettingValue();
}

/// The number.
inline void put(const SettingValue& value, double& into) {
  into = std::get<double>(value);
}
/// The number, whose fraction is dropped.
inline void put(const SettingValue& value, int& into) {
  into = static_cast<int>(std::get<double>(value));
}
/// The flag.
inline void put(const SettingValue& value, bool& into) {
  into = std::get<bool>(value);
}
/// The number of each axis.
inline void put(const SettingValue& value, Vec3& into) {
  into = std::get<Vec3>(value);
}
/// The number, or none.
inline void put(const SettingValue& value, std::optional<double>& into) {
  into = isNone(value) ? std::nullopt : std::optional(std::get<double>(value));
}

/// The kind that goes with a member's type.
constexpr SettingKind kindOf(double) {
  return SettingKind::Number;
}
/// As of a number.
constexpr SettingKind kindOf(const std::optional<double>&) {
  return SettingKind::Number;
}
/// A whole number.
constexpr SettingKind kindOf(int) {
  return SettingKind::Whole;
}
/// A flag.
constexpr SettingKind kindOf(bool) {
  return SettingKind::Flag;
}

/// The row of a member, whose type gives the kind.
template <auto kMember>
constexpr SettingOf<ObjectOf<kMember>> member(Setting setting) {
  using Object = ObjectOf<kMember>;
  using Type = std::remove_cvref_t<decltype(std::declval<Object>().*kMember)>;
  if constexpr (std::is_same_v<Type, Vec3>)
    setting.kind = SettingKind::Gain;
  else
    setting.kind = kindOf(Type{});
  setting.object = kObject<Object>;
  return {setting, [](const Object& object) { return valueOf(object.*kMember); },
          [](Object& object, const SettingValue& value) { put(value, object.*kMember); },
          [](const Object&) { return valueOf(Object{}.*kMember); }};
}

/// The words of a table, in its order.
template <const auto& kWords>
std::vector<std::string> wordsOf() {
  std::vector<std::string> all;
  for (const auto& word : kWords) all.emplace_back(word.word);
  return all;
}

/// The enumerator of a word; a word that the table does not have changes nothing.
template <const auto& kWords, class Enum>
void putWord(const SettingValue& value, Enum& into) {
  for (const auto& word : kWords) {
    if (std::get<std::string>(value) == word.word) into = word.value;
  }
}

/// The row of a member that is one of the words. kShown: the labels of the words in panels; by default the words.
template <auto kMember, const auto& kWords, const auto&... kShown>
constexpr SettingOf<ObjectOf<kMember>> oneOf(Setting setting) {
  static_assert(((std::size(kShown) == std::size(kWords)) && ...));
  ((setting.shown = kShown), ...);
  using Object = ObjectOf<kMember>;
  setting.kind = SettingKind::Choice;
  setting.words = &wordsOf<kWords>;
  setting.object = kObject<Object>;
  return {setting, [](const Object& object) -> SettingValue { return std::string(wordOf(kWords, object.*kMember)); },
          [](Object& object, const SettingValue& value) { putWord<kWords>(value, object.*kMember); },
          [](const Object&) -> SettingValue { return std::string(wordOf(kWords, Object{}.*kMember)); }};
}

/// The row of a number of one of the filters.
template <auto kMember>
constexpr SettingOf<Velocity> ofFilter(Setting setting, SettingKind kind = SettingKind::Number) {
  using Filter = ObjectOf<kMember>;
  setting.kind = kind;
  setting.object = kObject<Velocity>;
  return {setting,
          [](const Velocity& velocity) { return valueOf(std::get<Filter>(velocity).*kMember); },
          [](Velocity& velocity, const SettingValue& value) { put(value, std::get<Filter>(velocity).*kMember); },
          [](const Velocity&) { return valueOf(Filter{}.*kMember); },
          nullptr,
          [](const Velocity& velocity) { return std::holds_alternative<Filter>(velocity); }};
}

/// Which filter it is; a change to another one takes that one's default settings.
constexpr SettingOf<Velocity> filter(Setting setting) {
  setting.kind = SettingKind::Choice;
  setting.words = &wordsOf<kFilterWords>;
  setting.object = kObject<Velocity>;
  return {setting, [](const Velocity& velocity) -> SettingValue { return std::string(filterName(velocity)); },
          [](Velocity& velocity, const SettingValue& value) {
            static const Velocity kDefault[] = {KalmanFilter{}, LowPassFilter{}, AdaptiveWindowFilter{}, RawFilter{}};
            std::size_t wanted = velocity.index();
            putWord<kFilterWords>(value, wanted);
            if (wanted != velocity.index()) velocity = kDefault[wanted];
          },
          [](const Velocity&) -> SettingValue { return std::string(filterName({})); }};
}

/// The row with a rule of its own in place of its range.
template <class Object>
constexpr SettingOf<Object> checkedBy(Sentence (*valueProblem)(const Object&, double), SettingOf<Object> row) {
  row.valueProblem = valueProblem;
  return row;
}
/// The row for those objects alone for which is_there() is true.
template <class Object>
constexpr SettingOf<Object> presentIf(bool (*is_there)(const Object&), SettingOf<Object> row) {
  row.is_there = is_there;
  return row;
}

/// gainProblem(), as a rule of a row.
template <class Object>
Sentence checkedAsGain(const Object&, double number) {
  return gainProblem(number);
}

/// The row of a gain. kFrom: the first law that uses it; the later ones do, too.
template <auto kMember, LawType kFrom>
constexpr SettingOf<Control> gain(Setting setting) {
  setting.min = 0.0;
  setting.max = kHighestGain;
  SettingOf<Control> row{setting,
                         [](const Control& control) { return valueOf(control.gains.*kMember); },
                         [](Control& control, const SettingValue& value) { put(value, control.gains.*kMember); },
                         [](const Control&) { return valueOf(Gains{}.*kMember); },
                         checkedAsGain<Control>,
                         nullptr,
                         [](const Control& control) { return control.law >= kFrom; }};
  row.is.kind = SettingKind::Gain;
  row.is.object = kObject<Control>;
  return row;
}

}  // namespace underact::scene::row
