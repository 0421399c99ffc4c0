#pragma once
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/base/translate.h"
#include "core/scene/read_parts.h"
#include "core/scene/settings.h"

namespace underact::scene {

// The rows of each kind of object, for code that has the object at hand.

/// A setting, and how an object that has it gives and takes its value.
template <class Object>
struct SettingOf {
  Setting is;
  SettingValue (*get)(const Object& object);
  void (*set)(Object& object, const SettingValue& value);                   // value: of the setting's kind
  SettingValue (*default_value)(const Object& object);                      // the default, where the key is left out
  Sentence (*valueProblem)(const Object& object, double number) = nullptr;  // null: by the range
  bool (*is_there)(const Object& object) = nullptr;  // whether the object can have it; null: always
  bool (*is_used)(const Object& object) = nullptr;   // whether it has an effect; null: always
};

/// The rows of several kinds of objects; kHas: whether an object is one of them.
template <class... Object>
struct RowsFor {
  std::tuple<std::span<const SettingOf<Object>>...> rows;
  /// The rows outlive it.
  constexpr explicit RowsFor(std::span<const SettingOf<Object>>... its_rows) : rows(its_rows...) {}
  template <class One>
  static constexpr bool kHas = (std::is_same_v<One, Object> || ...);
};
/// The objects of a scene that have settings.
using AllRows = RowsFor<Description, Simulation, Control, Velocity, Constraint, Influence, Friction, Mesh, Curve,
                        CurveGuidance, VirtualManipulator, Solver, Joint>;
/// The table of settings.cpp.
const AllRows& allRows();

/// The rows of an object, in the order of a file; empty for any other type.
template <class Object>
std::span<const SettingOf<Object>> rowsOf() {
  if constexpr (AllRows::kHas<Object>)
    return std::get<std::span<const SettingOf<Object>>>(allRows().rows);
  else
    return {};
}

/// Whether this object may have the setting.
template <class Object>
bool isThere(const SettingOf<Object>& row, const Object& object) {
  return row.is_there == nullptr || row.is_there(object);
}

/// Whether both are bit-identical: -0 is not 0, so that a value left out of a file reads back as it was.
bool isSameValue(const SettingValue& a, const SettingValue& b);

/// Reads a value; false, and a problem, where it is not of the setting's kind.
bool readValue(const Setting& is, const json::Value& value, const std::string& path, SettingValue& into,
               Findings& findings);

/// The problem of a number outside the range; empty: none.
Sentence rangeProblem(const Setting& is, double number);

/// Calls say(part, sentence) for each number of the value that is not allowed; part: "", or "[1]" of a list.
template <class Object, class Say>
void valueProblem(const SettingOf<Object>& row, const Object& object, const SettingValue& value, const Say& say) {
  const auto look = [&](const std::string& part, double number) {
    Sentence wrong = row.valueProblem != nullptr ? row.valueProblem(object, number) : rangeProblem(row.is, number);
    if (!wrong.empty()) say(part, std::move(wrong));
  };
  if (const double* number = std::get_if<double>(&value)) look("", *number);
  const auto* const axes = std::get_if<Vec3>(&value);
  if (axes == nullptr) return;
  const bool is_one = isSameValue(*axes, Vec3(Vec3::Constant(axes->x())));  // even where they are no numbers
  for (Eigen::Index axis = 0; axis < (is_one ? 1 : 3); ++axis)
    look(is_one ? "" : "[" + std::to_string(axis) + "]", (*axes)[axis]);
}

/// Calls say(key, sentence) for each number of the object's settings that is not allowed.
template <class Object, class Say>
void checkSettings(const Object& object, const Say& say) {
  for (const SettingOf<Object>& row : rowsOf<Object>()) {
    if (!isThere(row, object)) continue;
    valueProblem(row, object, row.get(object),
                 [&](const std::string& part, Sentence wrong) { say(row.is.key + part, std::move(wrong)); });
  }
}

/// Reads one setting. False: the key is missing, or its value cannot be read.
template <class Object>
bool readSetting(ObjectReader& reader, const SettingOf<Object>& row, Object& into) {
  const json::Value* const found = reader.find(row.is.key, row.is.given == KeyPresence::Required);
  if (found == nullptr) {
    if (row.is.given != KeyPresence::Required) row.set(into, row.default_value(into));
    return false;
  }
  const std::string path = reader.pathOf(row.is.key);
  SettingValue value = row.get(into);
  bool is_good = readValue(row.is, *found, path, value, reader.findings());
  if (is_good && row.is.kind == SettingKind::Whole) {  // what is no whole number has no place in the scene
    valueProblem(row, into, value, [&](const std::string&, Sentence wrong) {
      reader.findings().add(*found, path, std::move(wrong));
      is_good = false;
    });
  }
  if (is_good) row.set(into, value);
  return is_good;
}

/// Reads all settings of an object; a choice on which others depend is read before them.
template <class Object>
void readSettings(ObjectReader& reader, Object& into) {
  for (const SettingOf<Object>& row : rowsOf<Object>()) {
    if (isThere(row, into)) readSetting(reader, row, into);
  }
}

/// Reads an object of a file that has settings only. what: "an influence"; example: of such an object.
template <class Object>
void readObject(const json::Value& value, const std::string& path, const Sentence& what, const char* example,
                Object& into, Findings& findings) {
  if (!isKind(value, json::JsonKind::Object, path, phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {example}),
              findings))
    return;
  ObjectReader reader(value, path, what, findings);
  readSettings(reader, into);
  reader.finish();
}

/// Whether all settings have their defaults, so that a file may leave the object out.
template <class Object>
bool isDefault(const Object& object) {
  for (const SettingOf<Object>& row : rowsOf<Object>()) {
    if (isThere(row, object) && !isSameValue(row.get(object), row.default_value(object))) return false;
  }
  return true;
}

}  // namespace underact::scene
