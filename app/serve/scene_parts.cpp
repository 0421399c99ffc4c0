#include "app/serve/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/serve/request.h"
#include "core/json/text.h"
#include "core/json/value_text.h"
#include "core/scene/all_settings.h"
#include "core/scene/edit.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/scene/settings.h"
#include "core/scene/write.h"
#include "core/system/resource_paths.h"

namespace underact::serve {
namespace {

constexpr const char* kOnlyConstraint = "/constraints/0";

/// The keys that say where each kind of constraint is, and how large.
const std::vector<std::string>& placementKeys() {
  static const std::vector<std::string> kKeys{
      "position_mm", "center_mm", "point_mm", "radius_mm", "size_mm", "direction",        "normal",
      "axis",        "R_WB",      "X_WM",     "X_WV_home", "joints",  "scale_mm_per_unit"};
  return kKeys;
}

json::Value textValue(const std::string& text) {
  json::Value value;
  value.kind = json::JsonKind::String;
  value.text = text;
  return value;
}

void put(json::Value& object, const std::string& key, json::Value value) {
  const auto found = std::find(object.keys.begin(), object.keys.end(), key);
  if (found != object.keys.end()) {
    object.items[static_cast<std::size_t>(found - object.keys.begin())] = std::move(value);
    return;
  }
  object.keys.push_back(key);
  object.key_places.emplace_back(value.line, value.column);
  object.items.push_back(std::move(value));
}

/// The problems of a scene of one constraint, as those of the constraint.
Problems ofConstraint(const Problems& problems) {
  Problems moved = problems;
  for (Problem& problem : moved) {
    std::string pointer = pointerOf(problem.place.key);
    if (pointer.starts_with(kOnlyConstraint)) pointer.erase(0, std::string(kOnlyConstraint).size());
    problem.place.key = pointer;
  }
  return moved;
}

/// A constraint as the scene would read it from a file.
Result<scene::Constraint> readAlone(const scene::Description& scene, const json::Value& constraint) {
  scene::Description around = scene;
  around.constraints = {{"alone", scene::Point{}, target::Side::Both, {}}};
  Result<json::Value> root = json::parse(scene::writeScene(around), {});
  if (!root) return root.problems();
  json::Value list;
  list.kind = json::JsonKind::Array;
  list.items.push_back(constraint);
  put(root.value(), "constraints", list);
  Result<scene::Description> alone = scene::readScene(json::textOf(root.value()), scene.file);
  if (!alone) return ofConstraint(alone.problems());
  return std::move(alone.value().constraints.front());
}

std::optional<std::size_t> indexOf(const scene::Description& scene, const std::string& name) {
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    if (scene.constraints[index].name == name) return index;
  }
  return std::nullopt;
}

Problems noSuchConstraint(const scene::Description& scene, const std::string& name) {
  std::vector<std::string> names;
  for (const scene::Constraint& constraint : scene.constraints) names.push_back(constraint.name);
  return problemAt("/name", "The scene has no constraint " + json::shown(name) + ". It has " +
                                std::string(json::listed(names, "and")) + ".");
}

/// Why it cannot be carried; empty: it can. Only a shape or a mesh whose nearest point is not searched in the metric of
/// unequal gains has numbers of its own in each tick.
std::string notCarried(const scene::Description& scene, std::size_t index) {
  const scene::Constraint& constraint = scene.constraints[index];
  const char* const type = scene::typeName(constraint.shape);
  if (std::holds_alternative<scene::VirtualManipulator>(constraint.shape) ||
      std::holds_alternative<scene::Curve>(constraint.shape))
    return std::string("A ") + type + " cannot be carried over time. Omit \"over_ms\": it is moved at once.";
  const scene::Control& control = scene::controlOf(scene, index);
  const Vec3& kp = control.gains.kp_N_per_mm;
  const bool is_weighted = control.space == tick::Space::Cartesian &&
                           control.anisotropy == scene::Anisotropy::Weighted && !(kp.x() == kp.y() && kp.y() == kp.z());
  if (is_weighted && !std::holds_alternative<scene::Point>(constraint.shape))
    return "With unequal gains in their own metric, this cannot be carried over time. Omit \"over_ms\", or set "
           "\"anisotropy\" to \"euclidean\".";
  return {};
}

void keepLoaded(const scene::Shape& before, scene::Shape& after) {
  const auto* const mesh = std::get_if<scene::Mesh>(&before);
  auto* const moved = std::get_if<scene::Mesh>(&after);
  if (mesh == nullptr || moved == nullptr) return;
  moved->surface = mesh->surface;
  moved->facts = mesh->facts;
  moved->loaded_checksum = mesh->loaded_checksum;
}

const char* typeWordOf(const scene::Setting& setting) {
  switch (setting.kind) {
    case scene::SettingKind::Number:
      return "number";
    case scene::SettingKind::Whole:
      return "whole";
    case scene::SettingKind::Gain:
      return "gain";
    case scene::SettingKind::Choice:
      return "choice";
    case scene::SettingKind::Flag:
      return "flag";
  }
  return "number";
}

json::ObjectText settingText(const scene::Description& scene, const std::string& path) {
  const scene::Setting setting = scene::settingAt(scene, path).value();
  json::ObjectText text;
  text.addText("path", path);
  text.addText("type", typeWordOf(setting));
  text.addText("unit", setting.unit);
  if (std::isfinite(setting.min)) text.addNumber("min", setting.min);
  if (std::isfinite(setting.max)) text.addNumber("max", setting.max);
  const scene::SettingValue default_value = scene::defaultAt(scene, path).value(),
                            value = scene::valueAt(scene, path).value();
  if (!scene::isNone(default_value)) text.addJson("default", scene::fileTextOf(default_value));
  if (!scene::isNone(value)) text.addJson("value", scene::fileTextOf(value));
  text.addBool("applies", scene::appliesAt(scene, path));
  text.addText("label", setting.label);
  if (setting.kind == scene::SettingKind::Choice) text.addTexts("words", setting.words());
  return text;
}

}  // namespace

Result<scene::Constraint> readConstraint(const scene::Description& scene, const json::Value& constraint) {
  json::Value named = constraint;
  if (constraint.find("name") == nullptr) {
    const json::Value* const type = constraint.find("type");
    put(named, "name", textValue(type != nullptr && type->kind == json::JsonKind::String ? type->text : "constraint"));
  }
  Result<scene::Constraint> read = readAlone(scene, named);
  if (!read) return read;
  scene::Description around = scene;
  around.constraints = {std::move(read).value()};
  if (const Problems problems = scene::loadMeshes(around); !problems.empty()) return ofConstraint(problems);
  return std::move(around.constraints.front());
}

Result<scene::Description> withConstraint(const scene::Description& scene, scene::Constraint constraint,
                                          bool is_named) {
  if (is_named && indexOf(scene, constraint.name))
    return problemAt("/name", "The scene has a constraint of this name already. Give another name.");
  if (scene.constraints.size() >= tick::kMaxConstraints)
    return problemAt("", "A scene has at most " + std::to_string(tick::kMaxConstraints) + " constraints.");
  return scene::withAdded(scene, std::move(constraint));
}

Result<scene::Description> withoutConstraint(const scene::Description& scene, const std::string& name) {
  const std::optional<std::size_t> index = indexOf(scene, name);
  if (!index) return noSuchConstraint(scene, name);
  if (scene.constraints.size() == 1)
    return problemAt("/name", "This is the scene's only constraint, and a scene needs one. Add another one first.");
  return scene::without(scene, *index);
}

Result<scene::Description> withMoved(const scene::Description& scene, const std::string& name,
                                     const json::Value& values, bool over_time) {
  const std::optional<std::size_t> index = indexOf(scene, name);
  if (!index) return noSuchConstraint(scene, name);
  if (const std::string why = over_time ? notCarried(scene, *index) : std::string(); !why.empty())
    return problemAt("/over_ms", why);
  scene::Description only = scene;
  only.constraints = {scene.constraints[*index]};
  Result<json::Value> root = json::parse(scene::writeScene(only), {});
  if (!root) return root.problems();
  json::Value constraint = root.value().find("constraints")->items.front();
  Problems problems;
  for (std::size_t at = 0; at < values.keys.size(); ++at) {
    const std::string& key = values.keys[at];
    if (problems.size() >= kMaxProblems) break;
    if (std::find(placementKeys().begin(), placementKeys().end(), key) == placementKeys().end()) {
      problems.push_back(
          {"This key does not say where a constraint is, or how large. A setting is changed by \"set\", "
           "with its path.",
           {{}, 0, 0, "/values/" + key}});
    } else {
      put(constraint, key, values.items[at]);
    }
  }
  if (!problems.empty()) return problems;
  if (values.keys.empty())
    return problemAt("/values", "This must have a key at least, as in {\"center_mm\": [0, 0, 10]}.");
  Result<scene::Constraint> read = readAlone(scene, constraint);
  if (!read) return below("/values", read.problems());
  scene::Description moved = scene;
  keepLoaded(moved.constraints[*index].shape, read.value().shape);
  moved.constraints[*index].shape = std::move(read.value().shape);
  return moved;
}

Result<scene::Description> sceneOf(const std::string& text, const std::string& beside) {
  Result<scene::Description> scene = scene::readScene(text, beside);
  if (!scene) return scene;
  if (Problems problems = scene::loadMeshes(scene.value()); !problems.empty()) return problems;
  return scene;
}

Result<scene::Description> openScene(const std::string& name) {
  std::string path = name;
  if (name.find('/') == std::string::npos) {
    const Result<std::string> folder = system::findResource(system::Resource::Scenes);
    if (!folder) return folder.problems();
    path = folder.value() + "/" + name + (name.ends_with(".json") ? "" : ".json");
    std::error_code error;
    if (!std::filesystem::exists(path, error))
      return problemAt("",
                       "No scene of this name comes with the program. Give one of them, or the absolute path of a "
                       "scene file.");
  } else if (!std::filesystem::path(name).is_absolute()) {
    return problemAt("", "The path of a scene file must be absolute: the service has another current folder than you.");
  }
  Result<scene::Description> scene = scene::readSceneFile(path);
  if (!scene) return scene;
  if (Problems problems = scene::loadMeshes(scene.value()); !problems.empty()) return problems;
  return scene;
}

Result<scene::Description> editedBy(const Request& request, const scene::Description& scene) {
  Keys keys(request);
  const json::Value* const values = keys.object("values");
  if (!keys.areGood()) return keys.problems();
  if (values->keys.empty()) return problemAt("/values", "This must have a path at least, with its value.");
  if (values->keys.size() > kMaxSettings) return problemAt("/values", "These are too many values.");
  return scene::withFileValues(scene, *values, kMaxProblems, kMaxHints);
}

Result<std::string> valuesFor(const Request& request, const scene::Description& scene) {
  Keys keys(request);
  const json::Value* const paths = keys.list("paths");
  std::string values;
  if (paths != nullptr && paths->items.size() > kMaxSettings) keys.add(*paths, "paths", "These are too many paths.");
  std::size_t problems = 0;
  for (std::size_t at = 0; paths != nullptr && at < std::min(paths->items.size(), kMaxSettings); ++at) {
    const json::Value& path = paths->items[at];
    ++problems;
    if (path.kind != json::JsonKind::String) {
      keys.add(path, "paths[" + std::to_string(at) + "]", "This must be the path of a setting, as text.");
    } else if (const std::string where = path.text.empty() ? "paths" : path.text;
               problems > kMaxHints && !scene::hasSetting(scene, path.text)) {
      keys.add(path, where, "There is no such setting.");
    } else if (const Result<scene::SettingValue> value = scene::valueAt(scene, path.text); !value) {
      keys.add(path, where, value.problems().front().sentence);
    } else if (scene::isNone(value.value())) {
      keys.add(path, where, "This setting has no value now.");
    } else {
      --problems;
      values += (values.empty() ? "" : ", ") + scene::fileTextOf(value.value());
    }
    if (problems >= kMaxProblems) break;
  }
  if (!keys.areGood()) return keys.problems();
  return "[" + values + "]";
}

std::string settingsText(const scene::Description& scene) {
  std::string list;
  for (const std::string& path : scene::settingPaths(scene))
    list += (list.empty() ? "" : ", ") + settingText(scene, path).text();
  return "[" + list + "]";
}

}  // namespace underact::serve
