#include "core/json/value_text.h"

namespace underact::json {

std::string textOf(const Value& value) {
  switch (value.kind) {
    case JsonKind::Null:
      return "null";
    case JsonKind::Bool:
      return value.boolean ? "true" : "false";
    case JsonKind::Number:
      return numberText(value.number);
    case JsonKind::String:
      return quotedText(value.text);
    case JsonKind::Array:
    case JsonKind::Object:
      break;
  }
  const bool is_object = value.kind == JsonKind::Object;
  std::string text(is_object ? "{" : "[");
  for (std::size_t index = 0; index < value.items.size(); ++index) {
    if (index > 0) text += ", ";
    if (is_object) text += quotedText(value.keys[index]) + ": ";
    text += textOf(value.items[index]);
  }
  return text + (is_object ? "}" : "]");
}

}  // namespace underact::json
