#include "app/guide/json_page.h"

namespace underact::guide {
namespace {

using json::JsonKind;
using json::Value;

constexpr std::size_t kColumns = 120;

std::string scalarText(const Value& value) {
  switch (value.kind) {
    case JsonKind::Null:
      return "null";
    case JsonKind::Bool:
      return value.boolean ? "true" : "false";
    case JsonKind::Number:
      return json::numberText(value.number);
    default:
      return json::quotedText(value.text);
  }
}

std::string nameOf(const Value& value, std::size_t i) {
  return value.kind == JsonKind::Object ? json::quotedText(value.keys[i]) + ": " : std::string();
}

std::string inOneLine(const Value& value) {
  if (value.kind != JsonKind::Object && value.kind != JsonKind::Array) return scalarText(value);
  std::string text;
  for (std::size_t i = 0; i < value.items.size(); ++i)
    text += (i == 0 ? "" : ", ") + nameOf(value, i) + inOneLine(value.items[i]);
  return value.kind == JsonKind::Object ? "{" + text + "}" : "[" + text + "]";
}

/// before: what stands in its first line already.
void write(const Value& value, std::size_t indent, std::size_t before, std::string& out) {
  const std::string line = inOneLine(value);
  if (value.items.empty() || before + line.size() + 1 <= kColumns) {
    out += line;
    return;
  }
  const bool is_object = value.kind == JsonKind::Object;
  const std::string space(indent + 2, ' ');
  out += is_object ? "{\n" : "[\n";
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    const std::string name = nameOf(value, i);
    out += space + name;
    write(value.items[i], indent + 2, space.size() + name.size(), out);
    out += i + 1 < value.items.size() ? ",\n" : "\n";
  }
  out += std::string(indent, ' ') + (is_object ? '}' : ']');
}

}  // namespace

std::string jsonPage(const Value& value) {
  std::string out;
  write(value, 0, 0, out);
  return out + '\n';
}

}  // namespace underact::guide
