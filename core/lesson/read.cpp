#include "core/lesson/read.h"

#include <cmath>
#include <tuple>

#include "core/arm/sample.h"
#include "core/base/translate.h"
#include "core/json/text.h"
#include "core/lesson/read_parts.h"
#include "core/lesson/window_names.h"

namespace underact::lesson {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 20;

void readVersion(ObjectReader& object) {
  const json::Value* const value = object.find("underact_lesson", true);
  if (value == nullptr) return;
  double number = 1.0;
  readNumber(*value, "underact_lesson", number, object.findings());
  if (number != 1.0)
    object.findings().add(*value, "underact_lesson",
                          phrase(TRANSLATE_NOOP("problem", "This must be the number 1, the version of lesson files.")));
}

/// Words, each of which has to be one of known; what: "layer".
std::vector<std::string> readNames(ObjectReader& object, const char* key, std::span<const char* const> known,
                                   const Sentence& what) {
  std::vector<std::string> names;
  const json::Value* const list = object.find(key);
  if (list == nullptr) return names;
  const std::string path = object.pathOf(key);
  if (!isKind(*list, json::JsonKind::Array, path, phrase(TRANSLATE_NOOP("problem", "a list of names")),
              object.findings()))
    return names;
  const std::vector<std::string> all(known.begin(), known.end());
  for (std::size_t index = 0; index < list->items.size(); ++index) {
    const std::string at = path + "[" + std::to_string(index) + "]";
    names.push_back(readName(list->items[index], at, all, what, object.findings()));
  }
  return names;
}

std::string readCamera(ObjectReader& object) {
  const json::Value* const value = object.find("camera");
  if (value == nullptr) return {};
  const std::span<const char* const> known = cameraNames();
  return readName(*value, object.pathOf("camera"), {known.begin(), known.end()},
                  phrase(TRANSLATE_NOOP("problem", "camera")), object.findings());
}

void readChecks(ObjectReader& object, std::vector<Check>& into) {
  const json::Value* const list = object.find("checks");
  if (list == nullptr) return;
  const std::string path = object.pathOf("checks");
  if (!isKind(*list, json::JsonKind::Array, path, phrase(TRANSLATE_NOOP("problem", "a list of checks")),
              object.findings()))
    return;
  if (list->items.size() > kMaxChecks)
    object.findings().add(
        *list, path, phrase(TRANSLATE_NOOP("problem", "A step has at most %1 checks."), {std::to_string(kMaxChecks)}));
  for (std::size_t index = 0; index < list->items.size() && index < kMaxChecks; ++index) {
    into.push_back(readCheck(list->items[index], path + "[" + std::to_string(index) + "]", object.findings()));
  }
}

bool readContinues(ObjectReader& object, bool is_first) {
  bool continues = false;
  const json::Value* const value = object.find("continues");
  if (value == nullptr) return continues;
  const std::string path = object.pathOf("continues");
  if (isKind(*value, json::JsonKind::Bool, path, phrase(TRANSLATE_NOOP("problem", "true or false")), object.findings()))
    continues = value->boolean;
  if (continues && is_first)
    object.findings().add(*value, path, phrase(TRANSLATE_NOOP("problem", "The first step has none before it.")));
  return continues;
}

void readPose(ObjectReader& object, std::vector<double>& into) {
  const json::Value* const list = object.find("pose_deg");
  if (list == nullptr) return;
  const std::string path = object.pathOf("pose_deg");
  if (!isKind(*list, json::JsonKind::Array, path, phrase(TRANSLATE_NOOP("problem", "a list of numbers")),
              object.findings()))
    return;
  if (list->items.empty() || list->items.size() > arm::kMaxJoints)
    object.findings().add(
        *list, path,
        phrase(TRANSLATE_NOOP("problem", "A pose has 1 to %1 joints."), {std::to_string(arm::kMaxJoints)}));
  for (std::size_t index = 0; index < list->items.size(); ++index) {
    double value = 0.0;
    readNumber(list->items[index], path + "[" + std::to_string(index) + "]", value, object.findings());
    into.push_back(value);
  }
}

Step readStep(const json::Value& value, const std::string& path, bool is_first, Findings& findings) {
  Step step;
  step.place = {findings.file(), value.line, value.column, path};
  if (!isKind(value, json::JsonKind::Object, path, phrase(TRANSLATE_NOOP("problem", "a step in { }")), findings))
    return step;
  ObjectReader object(value, path, phrase(TRANSLATE_NOOP("problem", "a step")), findings);
  step.title = readLine(object, "title", true);
  step.text = readProse(object, "text", true);
  step.hint = readProse(object, "hint", false);
  if (const json::Value* const scene = object.find("scene", is_first)) {
    readText(*scene, object.pathOf("scene"), step.scene, findings);
    if (step.scene.empty())
      findings.add(*scene, object.pathOf("scene"),
                   phrase(TRANSLATE_NOOP("problem", "Name a scene, as in \"02_sphere\" or \"my_scene.json\".")));
  }
  step.continues = readContinues(object, is_first);
  readPose(object, step.pose_deg);
  step.camera = readCamera(object);
  step.layers = readNames(object, "layers", layerNames(), phrase(TRANSLATE_NOOP("problem", "layer")));
  step.panels = readNames(object, "panels", panelNames(), phrase(TRANSLATE_NOOP("problem", "panel")));
  readChecks(object, step.checks);
  object.finish();
  return step;
}

void readSteps(ObjectReader& object, std::vector<Step>& into) {
  const json::Value* const list = object.find("steps", true);
  Findings& findings = object.findings();
  if (list == nullptr ||
      !isKind(*list, json::JsonKind::Array, "steps", phrase(TRANSLATE_NOOP("problem", "a list of steps")), findings))
    return;
  if (list->items.empty() || list->items.size() > kMaxSteps)
    findings.add(*list, "steps",
                 phrase(TRANSLATE_NOOP("problem", "A lesson has 1 to %1 steps."), {std::to_string(kMaxSteps)}));
  for (std::size_t index = 0; index < list->items.size() && index < kMaxSteps; ++index) {
    into.push_back(readStep(list->items[index], "steps[" + std::to_string(index) + "]", index == 0, findings));
  }
}

void readMinutes(ObjectReader& object, double& minutes) {
  const json::Value* const value = object.find("minutes");
  if (value == nullptr) return;
  readNumber(*value, "minutes", minutes, object.findings());
  if (value->kind == json::JsonKind::Number && !(minutes > 0.0))
    object.findings().add(*value, "minutes", phrase(TRANSLATE_NOOP("problem", "This must be above 0.")));
}

Lesson readWhole(const json::Value& root, Findings& findings) {
  Lesson lesson;
  lesson.file = findings.file();
  ObjectReader object(root, "", phrase(TRANSLATE_NOOP("problem", "a lesson")), findings);
  readVersion(object);
  lesson.title = readLine(object, "title", true);
  lesson.group = readLine(object, "group", false);
  lesson.about = readProse(object, "about", false);
  if (const json::Value* const order = object.find("order")) readNumber(*order, "order", lesson.order, findings);
  readMinutes(object, lesson.minutes);
  readSteps(object, lesson.steps);
  if (const json::Value* const schema = object.find("$schema")) {  // for editors; says nothing about the lesson
    isKind(*schema, json::JsonKind::String, "$schema", phrase(TRANSLATE_NOOP("problem", "text in double quotes")),
           findings);
  }
  object.finish();
  return lesson;
}

}  // namespace

Result<Lesson> readLesson(std::string_view text, const std::string& file_name) {
  const Result<json::Value> root = json::parse(text, file_name);
  if (!root) return root.problems();
  Findings findings(file_name);
  if (!isKind(root.value(), json::JsonKind::Object, "", phrase(TRANSLATE_NOOP("problem", "an object in { }")),
              findings))
    return findings.take();
  Lesson lesson = readWhole(root.value(), findings);
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return lesson;
}

Result<Lesson> readLessonFile(const std::string& path) {
  const Result<std::string> text =
      json::readTextFile(path, phrase(TRANSLATE_NOOP("problem", "a lesson")), kLargestFile);
  if (!text) return text.problems();
  return readLesson(text.value(), path);
}

}  // namespace underact::lesson
