#include "core/lesson/read_parts.h"

#include <algorithm>

#include "core/base/translate.h"

namespace underact::lesson {

std::string readName(const json::Value& value, const std::string& path, const std::vector<std::string>& known,
                     const Sentence& what, Findings& findings) {
  std::string name;
  if (!isKind(value, json::JsonKind::String, path, phrase(TRANSLATE_NOOP("problem", "the name of a %1"), {what}),
              findings))
    return name;
  readText(value, path, name, findings);
  if (std::find(known.begin(), known.end(), name) != known.end()) return name;
  const std::string nearest = findings.nearest(name, known);
  findings.add(value, path,
               nearest.empty() ? phrase(TRANSLATE_NOOP("problem", "There is no %1 %2. There are %3."),
                                        {what, json::shown(name), json::listed(known, "and")})
                               : phrase(TRANSLATE_NOOP("problem", "There is no %1 %2. Did you mean \"%3\"?"),
                                        {what, json::shown(name), nearest}));
  return name;
}

std::string readLine(ObjectReader& object, const char* key, bool required) {
  std::string line;
  const json::Value* const value = object.find(key, required);
  if (value == nullptr) return line;
  readText(*value, object.pathOf(key), line, object.findings());
  const bool is_blank = line.find_first_not_of(" \t\r\n") == std::string::npos;
  if (value->kind == json::JsonKind::String && (is_blank || line.find('\n') != std::string::npos))
    object.findings().add(*value, object.pathOf(key),
                          phrase(TRANSLATE_NOOP("problem", "This must be one line of text, not empty.")));
  return line;
}

std::string readProse(ObjectReader& object, const char* key, bool required) {
  std::string prose;
  const json::Value* const value = object.find(key, required);
  if (value == nullptr) return prose;
  const std::string path = object.pathOf(key);
  Findings& findings = object.findings();
  if (value->kind != json::JsonKind::Array) {
    if (isKind(*value, json::JsonKind::String, path,
               phrase(TRANSLATE_NOOP("problem", "text in double quotes, or a list of its lines")), findings))
      prose = value->text;
  } else {
    for (std::size_t index = 0; index < value->items.size(); ++index) {
      std::string line;
      readText(value->items[index], path + "[" + std::to_string(index) + "]", line, findings);
      prose += line + "\n";
    }
  }
  if (required && prose.find_first_not_of(" \t\r\n") == std::string::npos && value->kind != json::JsonKind::Null)
    findings.add(*value, path, phrase(TRANSLATE_NOOP("problem", "The text is empty.")));
  return prose;
}

}  // namespace underact::lesson
