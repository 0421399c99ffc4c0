#include "core/scene/difference.h"

#include <algorithm>

#include "core/json/json.h"
#include "core/scene/setting_rows.h"
#include "core/scene/write.h"

namespace underact::scene {
namespace {

using json::JsonKind;
using json::Value;

std::string textOf(const Value* value) {
  if (value == nullptr) return {};
  switch (value->kind) {
    case JsonKind::Null:
      return "null";
    case JsonKind::Bool:
      return value->boolean ? "true" : "false";
    case JsonKind::Number:
      return json::numberText(value->number);
    case JsonKind::String:
      return value->text;
    case JsonKind::Array:
    case JsonKind::Object:
      break;
  }
  std::string text;
  for (std::size_t index = 0; index < value->items.size(); ++index) {
    if (!text.empty()) text += ", ";
    if (value->kind == JsonKind::Object) text += value->keys[index] + ": ";
    text += textOf(&value->items[index]);
  }
  return value->kind == JsonKind::Array ? "[" + text + "]" : "{" + text + "}";
}

bool isList(const Value* value, JsonKind of) {
  return value != nullptr && value->kind == JsonKind::Array && !value->items.empty() &&
         std::all_of(value->items.begin(), value->items.end(), [of](const Value& item) { return item.kind == of; });
}

std::string nameOf(const Value& item, std::size_t index) {
  const Value* name = item.find("name");
  return name != nullptr ? name->text : std::to_string(index + 1);
}

void compare(const Value* one, const Value* other, const std::string& key, std::vector<Difference>& differences) {
  const auto inside = [&key](const std::string& part) { return key.empty() ? part : key + "." + part; };
  const bool both = one != nullptr && other != nullptr;
  const auto isObject = [](const Value* value) { return value == nullptr || value->kind == JsonKind::Object; };
  if ((one != nullptr || other != nullptr) && isObject(one) && isObject(other)) {
    static const Value kNothing;
    const Value &here = one != nullptr ? *one : kNothing, &there = other != nullptr ? *other : kNothing;
    for (const std::string& part : here.keys) compare(here.find(part), there.find(part), inside(part), differences);
    for (const std::string& part : there.keys) {
      if (here.find(part) == nullptr) compare(nullptr, there.find(part), inside(part), differences);
    }
  } else if (both && isList(one, JsonKind::Object) && isList(other, JsonKind::Object) &&
             one->items.size() == other->items.size()) {
    const bool are_constraints = key == "constraints";
    for (std::size_t index = 0; index < one->items.size(); ++index) {
      const std::string name = nameOf(one->items[index], index);
      compare(&one->items[index], &other->items[index], are_constraints ? name : inside(name), differences);
    }
  } else if (textOf(one) != textOf(other)) {
    differences.push_back({key, textOf(one), textOf(other)});
  }
}

/// Adds the values that a file leaves out of its control and a reader wants to see.
void addDefault(Value& control) {
  control.kind = JsonKind::Object;
  for (const SettingOf<Control>& row : rowsOf<Control>()) {
    if (control.find(row.is.key) != nullptr) continue;
    const SettingValue default_value = row.default_value({});
    Value value;
    value.kind = JsonKind::String;
    value.text = std::holds_alternative<std::string>(default_value) ? std::get<std::string>(default_value)
                                                                    : fileTextOf(default_value);
    control.keys.emplace_back(row.is.key);
    control.items.push_back(std::move(value));
  }
}

/// The scene without what cannot be felt, and with all of its control.
Value feltPartOf(Description scene) {
  scene.title.clear();
  scene.about.clear();
  Result<Value> read = json::parse(writeScene(scene), {});
  if (!read) return {};
  Value value = std::move(read).value();
  if (value.find("control") == nullptr) {
    value.keys.emplace_back("control");
    value.items.emplace_back();
  }
  const auto at = std::find(value.keys.begin(), value.keys.end(), "control") - value.keys.begin();
  addDefault(value.items[static_cast<std::size_t>(at)]);
  return value;
}

}  // namespace

std::vector<Difference> differencesBetween(const Description& one, const Description& other) {
  std::vector<Difference> differences;
  const Value a = feltPartOf(one), b = feltPartOf(other);
  compare(&a, &b, {}, differences);
  return differences;
}

}  // namespace underact::scene
