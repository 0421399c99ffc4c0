#include "core/scene/teaching.h"

#include "core/base/translate.h"
#include "core/json/text.h"
#include "core/scene/read_parts.h"

namespace underact::scene {
namespace {

void readPart(ObjectReader& object, const char* key, std::string& into) {
  const json::Value* value = object.find(key);
  if (value != nullptr) json::readText(*value, object.pathOf(key), into, object.findings());
}

}  // namespace

Teaching readTeaching(const json::Value& value, Findings& findings) {
  Teaching teaching;
  if (!isKind(value, json::JsonKind::Object, "teach",
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"),
                     {"{\"group\": \"shapes\", \"feel\": \"A spring.\"}"}),
              findings))
    return teaching;
  ObjectReader object(value, "teach", phrase(TRANSLATE_NOOP("problem", "what a scene teaches")), findings);
  if (const json::Value* group = object.find("group", true))
    readWord(*group, object.pathOf("group"), kGroupWords, teaching.group, findings);
  readPart(object, "feel", teaching.feel);
  readPart(object, "try", teaching.try_this);
  readPart(object, "equation", teaching.equation);
  object.finish();
  return teaching;
}

std::optional<Teaching> teachingIn(std::string_view text) {
  const Result<json::Value> root = json::parse(text, {});
  const json::Value* value = root ? root.value().find("teach") : nullptr;
  if (value == nullptr) return {};
  Findings findings({});
  const Teaching teaching = readTeaching(*value, findings);
  if (!findings.take().empty()) return {};
  return teaching;
}

std::optional<Teaching> teachingOf(const std::string& path) {
  const Result<std::string> text = json::readTextFile(path, phrase(TRANSLATE_NOOP("problem", "a scene")));
  if (!text) return {};
  return teachingIn(text.value());
}

}  // namespace underact::scene
