#include "app/cli/json_object.h"

#include "core/json/json.h"

namespace underact::cli {

void JsonObject::addText(std::string_view key, std::string_view value) {
  addRaw(key, json::quoted(value));
}

void JsonObject::addNumber(std::string_view key, double value) {
  addRaw(key, json::numberText(value));
}

void JsonObject::addVector(std::string_view key, const Vec3& value) {
  std::string list;
  for (const double coordinate : value) list += (list.empty() ? "" : ", ") + json::numberText(coordinate);
  addRaw(key, "[" + list + "]");
}

void JsonObject::addList(std::string_view key, const std::vector<JsonObject>& values) {
  std::string list;
  for (const JsonObject& value : values) list += (list.empty() ? "" : ", ") + value.text();
  addRaw(key, "[" + list + "]");
}

void JsonObject::addRaw(std::string_view key, const std::string& json) {
  if (!members_.empty()) members_ += ", ";
  members_ += json::quoted(key) + ": " + json;
}

}  // namespace underact::cli
