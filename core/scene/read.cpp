#include "core/scene/read.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/translate.h"
#include "core/scene/rules.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
namespace {

constexpr double kVersion = 1.0;

void readVersion(ObjectReader& object) {
  const json::Value* value = object.find("underact_scene", true);
  if (value == nullptr) return;
  Findings& findings = object.findings();
  if (!isKind(*value, json::JsonKind::Number, "underact_scene", phrase(TRANSLATE_NOOP("problem", "the number 1")),
              findings))
    return;
  if (value->number > kVersion && std::floor(value->number) == value->number && std::isfinite(value->number)) {
    findings.add(
        *value, "underact_scene",
        phrase(TRANSLATE_NOOP(
                   "problem",
                   "The scene has version %1, but this program only reads version 1. Use a newer version of Underact."),
               {json::numberText(value->number)}));
  } else if (value->number != kVersion) {
    findings.add(*value, "underact_scene",
                 phrase(TRANSLATE_NOOP("problem", "This must be the number 1, the version of scene files.")));
  }
}

/// Gives a unique name to each constraint that has none.
void makeUpNames(std::vector<Constraint>& constraints) {
  std::set<std::string> taken;
  for (const Constraint& constraint : constraints) taken.insert(constraint.name);
  for (std::size_t index = 0; index < constraints.size(); ++index) {
    std::string& name = constraints[index].name;
    if (!name.empty()) continue;
    name = defaultName(constraints[index], index);
    while (!taken.insert(name).second) name += "'";
  }
}

void readConstraints(ObjectReader& object, std::vector<Constraint>& into) {
  const json::Value* list = object.find("constraints", true);
  Findings& findings = object.findings();
  if (list == nullptr || !isKind(*list, json::JsonKind::Array, "constraints",
                                 phrase(TRANSLATE_NOOP("problem", "a list of constraints")), findings)) {
    into.emplace_back();  // a harmless one
  } else {
    const std::size_t count = list->items.size();
    if (count > tick::kMaxConstraints)  // only so many are read: a file may have a million
      findings.add(*list, "constraints", constraintCountProblem(count));
    into.resize(std::min(count, tick::kMaxConstraints));
    for (std::size_t index = 0; index < into.size(); ++index) {
      readConstraint(list->items[index], "constraints[" + std::to_string(index) + "]", into[index], findings);
    }
  }
  makeUpNames(into);
}

void readTexts(ObjectReader& object, Description& into) {
  Findings& findings = object.findings();
  into.title = "untitled";  // so that the title check adds no second problem
  if (const json::Value* title = object.find("title", true)) readText(*title, "title", into.title, findings);
  if (const json::Value* about = object.find("about")) readText(*about, "about", into.about, findings);
  if (const json::Value* arm = object.find("arm")) {
    readText(*arm, "arm", into.arm, findings);
    findings.remember("arm", *arm);
  }
  if (const json::Value* text = object.find("arm_text")) readText(*text, "arm_text", into.arm_text, findings);
}

Description readWhole(const json::Value& root, const std::string& file_name, Findings& findings) {
  Description scene;
  scene.file = file_name;
  ObjectReader object(root, "", phrase(TRANSLATE_NOOP("problem", "a scene")), findings);
  readVersion(object);
  readTexts(object, scene);
  if (const json::Value* control = object.find("control")) scene.control = readControl(*control, "control", findings);
  readSettings(object, scene);
  if (const json::Value* simulation = object.find("simulation"))
    readObject(*simulation, "simulation", phrase(TRANSLATE_NOOP("problem", "a simulation")), "{\"substep_us\": 50}",
               scene.simulation, findings);
  if (const json::Value* teach = object.find("teach")) readTeaching(*teach, findings);  // see teachingOf()
  readConstraints(object, scene.constraints);
  if (const json::Value* schema = object.find("$schema")) {  // for editors; not part of the scene
    isKind(*schema, json::JsonKind::String, "$schema", phrase(TRANSLATE_NOOP("problem", "text in double quotes")),
           findings);
  }
  object.refuse("velocity", belongsToControl());
  object.refuse("friction", belongsToConstraint());
  object.refuse("search", belongsToConstraint());
  object.refuseLater(kLaterKeys);
  object.finish();
  return scene;
}

}  // namespace

Result<Description> readScene(std::string_view text, const std::string& file_name, NamedFiles files) {
  const Result<json::Value> root = json::parse(text, file_name);
  if (!root) return root.problems();
  Findings findings(file_name);
  if (!isKind(root.value(), json::JsonKind::Object, "", kindName(json::JsonKind::Object), findings))
    return findings.take();
  Description scene = readWhole(root.value(), file_name, findings);
  const Problems of_arm = readSceneArm(scene, files);
  findings.add(check(of_arm.empty() ? scene : withArmOf({}, scene)));
  if (!of_arm.empty() && of_arm.front().place.line == 0) findings.add(of_arm);
  Problems problems = findings.take();
  if (!of_arm.empty() && of_arm.front().place.line > 0)  // in the other file
    problems.insert(problems.end(), of_arm.begin(), of_arm.end());
  if (!problems.empty()) return problems;
  return scene;
}

}  // namespace underact::scene
