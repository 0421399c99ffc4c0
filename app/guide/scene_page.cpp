#include "app/guide/scene_page.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "app/guide/markdown.h"
#include "app/guide/setting_table.h"
#include "core/json/json.h"
#include "core/json/text.h"

namespace underact::guide {
namespace {

using json::Value;

constexpr std::string_view kRef = "#/$defs/";
constexpr const char* kShared = "Keys of several types";
constexpr const char* kTableHead = "| key | value | default | meaning |\n|---|---|---|---|\n";
/// Parts of a scene that several keys have, each with a section of its own, in the order of reading.
constexpr std::array kParts{"control", "velocity", "influence", "friction", "joint", "solver", "curve_guide"};

std::string shownValue(const Value& value) {
  switch (value.kind) {
    case json::JsonKind::Bool:
      return value.boolean ? "true" : "false";
    case json::JsonKind::Number:
      return json::numberText(value.number);
    case json::JsonKind::String:
      return value.text;
    default:
      return {};
  }
}

bool isPart(const std::string& name) {
  return std::find(kParts.begin(), kParts.end(), name) != kParts.end();
}

/// Writes the page; a missing description in the schema is a problem.
class ScenePage {
 public:
  ScenePage(const Value& schema, std::string file) : schema_(schema), file_(std::move(file)) {}

  Result<std::string> make() {
    const Value* types = member(member(member(member(&schema_, "properties"), "constraints"), "items"), "oneOf");
    if (types == nullptr || !hasParts()) return Problems{{"This is not a scene schema.", {file_}}};
    out_ << "# Scene reference\n\nEvery key of a scene file. This page is generated from `scenes/scene.schema.json`, "
            "which "
            "editors also use. [Scene files](scenes.md) explains how the keys work together. "
         << plainText(textOf(schema_, "description", "the scene")) << "\n\n## The scene\n\n";
    writeTable(schema_);
    const Value* keys = schema_.find("properties");
    for (std::size_t i = 0; i < keys->keys.size(); ++i) {
      if (isObject(keys->items[i])) writeObject(keys->items[i], keys->keys[i]);
    }
    writeShared(*types);
    for (const Value& type : types->items) writeSection(nameOfRef(type), "Constraint of type ");
    for (const char* part : kParts) writeSection(part, "");
    if (!problems_.empty()) return problems_;
    return out_.str() + settingTable();
  }

 private:
  static const Value* member(const Value* object, const char* key) {
    return object == nullptr ? nullptr : object->find(key);
  }
  /// Whether everything that is referred to exists.
  bool hasParts() const {
    const Value* parts = schema_.find("$defs");
    return parts != nullptr && hasParts(schema_, *parts) &&
           std::all_of(kParts.begin(), kParts.end(), [&](const char* part) { return parts->find(part) != nullptr; });
  }
  static bool hasParts(const Value& value, const Value& parts) {
    const Value* ref = value.find("$ref");
    if (ref != nullptr && (ref->text.rfind(kRef, 0) != 0 || parts.find(nameOfRef(value)) == nullptr)) return false;
    return std::all_of(value.items.begin(), value.items.end(), [&](const Value& v) { return hasParts(v, parts); });
  }
  static const Value* property(const Value& object, const std::string& key) {
    const Value* properties = object.find("properties");
    return properties == nullptr ? nullptr : properties->find(key);
  }
  static std::string nameOfRef(const Value& value) {
    const Value* ref = value.find("$ref");
    return ref == nullptr ? std::string() : ref->text.substr(kRef.size());
  }
  const Value& resolved(const Value& value) const {
    const std::string name = nameOfRef(value);
    return name.empty() ? value : *schema_.find("$defs")->find(name);
  }

  std::string textOf(const Value& value, const char* key, const std::string& what) {
    const Value* text = value.find(key);
    if (text == nullptr) text = resolved(value).find(key);
    if (text == nullptr || text->text.empty())
      problems_.push_back({"The schema does not describe " + what + ".", {file_, value.line}});
    return text == nullptr ? std::string() : text->text;
  }

  void writeSection(const std::string& name, const std::string& kind) {
    const Value& part = *schema_.find("$defs")->find(name);
    out_ << "## " << name << "\n\n"
         << (kind.empty() ? "" : kind + inCode(name) + ". ") << plainText(textOf(part, "description", name)) << "\n\n";
    const Value* either = part.find("oneOf");
    if (either == nullptr) return writeTable(part);
    for (const Value& one : either->items) {
      const Value* filter = property(one, "filter");
      out_ << "### " << name << ": " << (filter == nullptr ? "one" : filter->find("const")->text) << "\n\n";
      writeTable(one);
    }
  }

  /// An object that is used in one place only, and so is not in $defs.
  static bool isObject(const Value& value) { return value.find("properties") != nullptr; }
  void writeObject(const Value& object, const std::string& name) {
    out_ << "## " << name << "\n\n" << plainText(textOf(object, "description", name)) << "\n\n";
    writeTable(object);
  }

  struct Row {
    std::string key, text;
  };

  std::vector<Row> rowsOf(const Value& object) {
    const Value* properties = object.find("properties");
    const Value* required = object.find("required");
    std::vector<Row> rows;
    for (std::size_t i = 0; i < properties->keys.size(); ++i) {
      const std::string& key = properties->keys[i];
      const Value& value = properties->items[i];
      const bool is_given = (key == "type" || key == "filter") && value.find("const") != nullptr;
      if (is_given) continue;  // by the heading
      const bool is_required = required != nullptr && std::any_of(required->items.begin(), required->items.end(),
                                                                  [&](const Value& r) { return r.text == key; });
      const Value* default_value = value.find("default");
      if (default_value == nullptr) default_value = resolved(value).find("default");
      rows.push_back({key, "| " + inCode(key) + " | " + kindOf(value, key) + " | " +
                               (is_required                ? "required"
                                : default_value == nullptr ? ""
                                                           : inCode(shownValue(*default_value))) +
                               " | " + cellText(textOf(value, "description", key)) + " |\n"});
    }
    return rows;
  }

  /// Rows of several types of constraints are told once, before the types.
  void writeShared(const Value& types) {
    constexpr int kSeveral = 3;
    std::map<std::string, int> counts;
    std::string table;
    for (const Value& type : types.items) {
      for (const Row& row : rowsOf(*schema_.find("$defs")->find(nameOfRef(type)))) {
        if (++counts[row.text] != kSeveral) continue;
        shared_.insert(row.text);
        table += row.text;
      }
    }
    out_ << "## " << kShared << "\n\nKeys of constraints of several types, as each type below names them.\n\n"
         << kTableHead << table << '\n';
  }

  void writeTable(const Value& object) {
    std::string table;
    std::vector<std::string> elsewhere;
    for (const Row& row : rowsOf(object)) {
      if (shared_.contains(row.text))
        elsewhere.push_back(row.key);
      else
        table += row.text;
    }
    if (!table.empty()) out_ << kTableHead << table << '\n';
    if (!elsewhere.empty())
      out_ << listedInCode(elsewhere) << ": as in [" << kShared << "](#keys-of-several-types).\n\n";
  }

  /// "a number from 0 to 1", "3 numbers", a link to its section.
  std::string kindOf(const Value& value, const std::string& key) {
    const std::string name = nameOfRef(value);
    if (isPart(name)) return "[" + name + "](#" + name + ")";
    if (isObject(value)) return "[" + key + "](#" + key + ")";
    const Value& is = resolved(value);
    if (const Value* constant = is.find("const")) return inCode(shownValue(*constant));
    if (const Value* words = is.find("enum")) {
      std::vector<std::string> all;
      for (const Value& word : words->items) all.push_back(shownValue(word));
      return listedInCode(all);
    }
    if (is.find("oneOf") != nullptr) return "a number, or 3";
    const std::string type = is.find("type") == nullptr ? "" : is.find("type")->text;
    if (const Value* either = is.find("anyOf"); either != nullptr && type.empty()) return eitherOf(*either, key);
    if (type == "array") return listOf(is);
    if (type == "boolean") return "`true`, `false`";
    if (type == "string") return "text";
    return (type == "integer" ? "a whole number" : "a number") + rangeOf(is);
  }

  std::string eitherOf(const Value& kinds, const std::string& key) {
    std::string all;
    for (const Value& kind : kinds.items) {
      const bool is_file = kind.find("pattern") != nullptr;
      all += (all.empty() ? "" : ", or ") + (is_file ? "a file name" : kindOf(kind, key));
    }
    return all;
  }

  std::string listOf(const Value& is) {
    const Value& items = *is.find("items");
    const Value* min = is.find("minItems");
    const Value* max = is.find("maxItems");
    std::string count = min == nullptr ? "" : json::numberText(min->number);
    if (max != nullptr && json::numberText(max->number) != count) count += " to " + json::numberText(max->number);
    const std::string name = nameOfRef(items);
    if (isPart(name)) return count + " of [" + name + "](#" + name + ")";
    if (items.find("oneOf") != nullptr) return count + " constraints, of the types below";
    if (items.find("type") != nullptr && items.find("type")->text == "array")
      return count + " rows of " + listOf(items);
    return count + " numbers" + rangeOf(resolved(items));
  }

  static std::string rangeOf(const Value& is) {
    const auto bound = [&](const char* key) {
      const Value* value = is.find(key);
      std::string text = value == nullptr ? std::string() : json::numberText(value->number);
      if (const std::size_t at = text.find("e+0"); at != std::string::npos) text.erase(at + 1, 2);  // 1e6, not 1e+06
      return text;
    };
    const std::string min = bound("minimum"), above = bound("exclusiveMinimum"), max = bound("maximum");
    if (!above.empty()) return " above " + above + (max.empty() ? "" : ", at most " + max);
    if (!min.empty() && !max.empty()) return " from " + min + " to " + max;
    return {};
  }

  const Value& schema_;
  std::string file_;
  std::ostringstream out_;
  std::set<std::string> shared_;  // rows
  Problems problems_;
};

}  // namespace

Result<std::string> scenePage(const std::string& schema_file) {
  const Result<std::string> text = json::readTextFile(schema_file, "a schema");
  if (!text) return text.problems();
  const Result<Value> schema = json::parse(text.value(), schema_file);
  if (!schema) return schema.problems();
  return ScenePage(schema.value(), schema_file).make();
}

}  // namespace underact::guide
