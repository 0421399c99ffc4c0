#include "app/guide/scene_schema.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/guide/json_page.h"
#include "app/guide/setting_table.h"
#include "core/json/json.h"
#include "core/json/text.h"
#include "core/scene/fields.h"

namespace underact::guide {
namespace {

using json::JsonKind;
using json::Value;
using scene::Setting;
using scene::SettingKind;

constexpr std::string_view kDefs = "#/$defs/";

Value emptyOf(JsonKind kind) {
  Value made;
  made.kind = kind;
  return made;
}
Value textValue(const std::string& text) {
  Value made = emptyOf(JsonKind::String);
  made.text = text;
  return made;
}
Value numberValue(double number) {
  Value made = emptyOf(JsonKind::Number);
  made.number = number;
  return made;
}
Value* member(Value& object, std::string_view key) {
  return const_cast<Value*>(std::as_const(object).find(key));
}
void set(Value& object, const std::string& key, Value value) {
  if (Value* const there = member(object, key)) {
    *there = std::move(value);
    return;
  }
  object.keys.push_back(key);
  object.items.push_back(std::move(value));
}

Value refTo(const std::string& part) {
  Value made = emptyOf(JsonKind::Object);
  set(made, "$ref", textValue(std::string(kDefs) + part));
  return made;
}

/// The schema of a shape of plain numbers.
template <scene::PlainShape Shape>
Value schemaOf(const Shape& shape) {
  constexpr const char* kOfMeaning[] = {"position", "length", "direction", "rotation"};
  Value made = emptyOf(JsonKind::Object), required = emptyOf(JsonKind::Array), keys = made, type = made;
  required.items.push_back(textValue("type"));
  set(keys, "name", refTo("name"));
  set(type, "const", textValue(typeName(shape)));
  set(keys, "type", std::move(type));
  eachField(shape, [&]<class Number>(const auto& field, const Number&) {
    const bool is_size = field.meaning == scene::Meaning::Length && !std::is_same_v<Number, double>;
    Value key = refTo(is_size ? "size" : kOfMeaning[static_cast<std::size_t>(field.meaning)]);
    if (field.about != nullptr) set(key, "description", textValue(field.about));
    set(keys, field.key, std::move(key));
    if (field.required) required.items.push_back(textValue(field.key));
  });
  if (hasSides(shape)) set(keys, "side", refTo("side"));
  if (takesInfluence(shape)) set(keys, "influence", refTo("influence"));
  if (takesFriction(shape)) set(keys, "friction", refTo("friction"));
  set(keys, "control", refTo("control"));
  set(made, "type", textValue("object"));
  set(made, "description", textValue(scene::kRow<Shape>.about));
  set(made, "additionalProperties", emptyOf(JsonKind::Bool));
  set(made, "required", std::move(required));
  set(made, "properties", std::move(keys));
  return made;
}

/// The tip, and the words of a choice that a panel, and so the tip, calls otherwise.
std::string descriptionOf(const Setting& setting) {
  std::string others;
  const std::vector<std::string> words = setting.shown == nullptr ? std::vector<std::string>() : setting.words();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string shown = setting.shown[i];
    if (shown.compare(0, words[i].size(), words[i]) != 0)
      others += (others.empty() ? "" : "; ") + words[i] + ": " + shown;
  }
  return setting.tip + (others.empty() ? others : " (" + others + ".)");
}

/// The schema of its value.
Value schemaOf(const Setting& setting, const scene::SettingValue& default_value) {
  Value made = emptyOf(JsonKind::Object);
  switch (setting.kind) {
    case SettingKind::Choice: {
      Value words = emptyOf(JsonKind::Array);
      for (const std::string& word : setting.words()) words.items.push_back(textValue(word));
      set(made, "enum", std::move(words));
      break;
    }
    case SettingKind::Flag:
      set(made, "type", textValue("boolean"));
      break;
    case SettingKind::Gain:
      set(made, "$ref", textValue(std::string(kDefs) + "gains"));
      break;
    case SettingKind::Number:
    case SettingKind::Whole:
      set(made, "type", textValue(setting.kind == SettingKind::Whole ? "integer" : "number"));
      if (setting.min > -kInfinity)
        set(made, setting.is_above_min ? "exclusiveMinimum" : "minimum", numberValue(setting.min));
      if (setting.max < kInfinity) set(made, "maximum", numberValue(setting.max));
      break;
  }
  if (setting.given != scene::KeyPresence::Required && !scene::isNone(default_value))
    set(made, "default", json::parse(scene::fileTextOf(default_value), "a default").value());
  set(made, "description", textValue(descriptionOf(setting)));
  return made;
}

/// A schema of scenes that is being brought up to the table.
class Schema {
 public:
  explicit Schema(Value root) : root_(std::move(root)), defs_(member(root_, "$defs")) {}

  /// False: it is no schema of scenes.
  bool takeShapes() {
    Value* types = member(root_, "properties");
    for (const char* key : {"constraints", "items", "oneOf"}) types = types == nullptr ? nullptr : member(*types, key);
    if (types == nullptr) return false;
    types->items.clear();
    scene::eachShape([&]<class Shape>(const Shape& shape) {
      types->items.push_back(refTo(typeName(shape)));
      if constexpr (scene::PlainShape<Shape>) set(*defs_, typeName(shape), schemaOf(shape));
    });
    return true;
  }
  bool take(const Setting& setting) {
    const SettingUse use = useOf(setting);
    const std::vector<Value*> objects = objectsOf(setting, use);
    if (objects.empty()) return false;
    for (Value* const object : objects) {
      Value* const keys = object == nullptr ? nullptr : member(*object, "properties");
      if (keys == nullptr) return false;
      if (std::string_view(setting.key) == "filter") continue;  // what tells the filters apart: a constant of each
      // What many types have stands in a part of its own, "side"; a type may add to the description.
      Value* const shared = part(setting.key);
      set(shared == nullptr ? *keys : *defs_, setting.key, schemaOf(setting, use.default_value));
      if (shared != nullptr && keys->find(setting.key) == nullptr) set(*keys, setting.key, refTo(setting.key));
      if (setting.given == scene::KeyPresence::Required) require(*object, setting.key);
    }
    return true;
  }
  const Value& root() const { return root_; }

 private:
  Value* part(const std::string& name) { return member(*defs_, name); }

  std::vector<Value*> objectsOf(const Setting& setting, const SettingUse& use) {
    const std::string object = setting.object;
    const std::string last = object.substr(object.rfind('/') + 1);
    if (object.empty()) return {&root_};
    if (object == "/simulation") return {member(*member(root_, "properties"), last)};
    if (object == "/constraints/*") {
      std::vector<Value*> found;
      for (const std::string& type : use.of) found.push_back(part(type));
      return found;
    }
    if (last == "velocity") return filtersOf(use);
    if (object.ends_with("/joints/*")) return {part("joint")};
    return {part(last == "guide" ? "curve_guide" : last)};
  }

  std::vector<Value*> filtersOf(const SettingUse& use) {
    Value* const velocity = part("velocity");
    if (velocity == nullptr) return {};
    std::vector<Value*> found;
    for (Value& one : member(*velocity, "oneOf")->items) {
      const std::string& name = one.find("properties")->find("filter")->find("const")->text;
      if (std::find(use.of.begin(), use.of.end(), name) != use.of.end()) found.push_back(&one);
    }
    return found;
  }

  static void require(Value& object, const std::string& key) {
    if (member(object, "required") == nullptr) set(object, "required", emptyOf(JsonKind::Array));
    std::vector<Value>& keys = member(object, "required")->items;
    if (std::none_of(keys.begin(), keys.end(), [&](const Value& one) { return one.text == key; }))
      keys.push_back(textValue(key));
  }

  Value root_;
  Value* defs_;
};

}  // namespace

Result<std::string> sceneSchema(const std::string& schema_file) {
  const Result<std::string> text = json::readTextFile(schema_file, "a schema");
  if (!text) return text.problems();
  Result<Value> read = json::parse(text.value(), schema_file);
  if (!read) return read.problems();
  const Problems wrong{{"This is no schema of scenes.", {schema_file}}};
  if (read.value().find("$defs") == nullptr || read.value().find("properties") == nullptr) return wrong;
  Schema schema(std::move(read.value()));
  if (!schema.takeShapes()) return wrong;
  for (const Setting& setting : scene::settings()) {
    if (!schema.take(setting)) return wrong;
  }
  return jsonPage(schema.root());
}

}  // namespace underact::guide
