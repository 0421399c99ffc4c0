// Settings by their paths.
#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "core/base/translate.h"
#include "core/scene/all_settings.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
namespace {

using Steps = std::span<const std::string>;

std::vector<std::string> stepsOf(std::string_view path) {
  std::vector<std::string> steps;
  while (!path.empty() && path.front() == '/') {
    path.remove_prefix(1);
    const std::size_t length = std::min(path.find('/'), path.size());
    steps.emplace_back(path.substr(0, length));
    path.remove_prefix(length);
  }
  if (!path.empty()) steps.clear();  // a path begins with /
  return steps;
}

std::string joinedSteps(Steps steps) {
  std::string path;
  for (const std::string& step : steps) path += "/" + step;
  return path;
}

std::optional<std::size_t> numberOfStep(const std::string& step) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), number);
  if (error != std::errc() || end != step.data() + step.size()) return std::nullopt;
  return number;
}

// Each calls visit(row, object) for the setting at the end of the steps; false: there is none. Optional objects are
// passed as std::optional.

template <class Object, class Visit>
bool atKey(Object& object, const std::string& key, const Visit& visit) {
  for (const auto& row : rowsOf<std::remove_const_t<Object>>()) {
    if (key != row.is.key || !isThere(row, std::as_const(object))) continue;
    visit(row, object);
    return true;
  }
  return false;
}

template <class Part, class Object, class Visit>
bool atOptional(Object& object, const std::string& key, const Visit& visit) {
  for (const SettingOf<Part>& row : rowsOf<Part>()) {
    if (key != row.is.key) continue;
    visit(row, object);
    return true;
  }
  return false;
}

template <class Its, class Visit>
bool atControl(Its& control, Steps steps, const Visit& visit) {
  if (steps.size() == 2 && steps[0] == "velocity") return atKey(control.velocity, steps[1], visit);
  return steps.size() == 1 && atKey(control, steps[0], visit);
}

template <class Its, class Visit>
bool inShape(Its& shape, Steps steps, const Visit& visit) {
  if (steps.size() == 1) return atKey(shape, steps[0], visit);
  using Plain = std::remove_const_t<Its>;
  if constexpr (std::is_same_v<Plain, Curve>)
    return steps.size() == 2 && steps[0] == "guide" && atOptional<CurveGuidance>(shape.guide, steps[1], visit);
  if constexpr (std::is_same_v<Plain, VirtualManipulator>) {
    if (steps.size() == 2 && steps[0] == "solver") return atKey(shape.solver, steps[1], visit);
    const std::optional<std::size_t> joint =
        steps.size() == 3 && steps[0] == "joints" ? numberOfStep(steps[1]) : std::nullopt;
    return joint && *joint < shape.joints.size() && atKey(shape.joints[*joint], steps[2], visit);
  }
  return false;
}

template <class Scene, class Visit>
bool inConstraint(Scene& scene, std::size_t index, Steps steps, const Visit& visit) {
  auto& constraint = scene.constraints[index];
  if (steps.size() > 1 && steps[0] == "control") {
    if constexpr (std::is_const_v<Scene>) {
      return atControl(controlOf(scene, index), steps.subspan(1), visit);
    } else {
      if (!constraint.control) constraint.control = scene.control;
      return atControl(*constraint.control, steps.subspan(1), visit);
    }
  }
  if (steps.size() == 2 && steps[0] == "influence")
    return takesInfluence(constraint.shape) && atOptional<Influence>(constraint.influence, steps[1], visit);
  if (steps.size() == 2 && steps[0] == "friction")
    return takesFriction(constraint.shape) && atOptional<Friction>(constraint.friction, steps[1], visit);
  if (steps.size() == 1 && atKey(constraint, steps[0], visit)) return true;
  return std::visit([&](auto& shape) { return inShape(shape, steps, visit); }, constraint.shape);
}

template <class Scene, class Visit>
bool inScene(Scene& scene, Steps steps, const Visit& visit) {
  if (steps.empty()) return false;
  if (steps.size() == 1) return atKey(scene, steps[0], visit);
  if (steps[0] == "control") return atControl(scene.control, steps.subspan(1), visit);
  if (steps[0] == "simulation") return steps.size() == 2 && atKey(scene.simulation, steps[1], visit);
  const std::optional<std::size_t> index = steps[0] == "constraints" ? numberOfStep(steps[1]) : std::nullopt;
  return index && *index < scene.constraints.size() && inConstraint(scene, *index, steps.subspan(2), visit);
}

Problems problemAt(const std::string& path, Sentence sentence) {
  return {{std::move(sentence), {{}, 0, 0, path}}};
}

/// The problem of a path without a setting in the scene.
Problems nowhere(const Description& scene, const std::string& path) {
  const Setting* const setting = findSetting(path);
  if (setting == nullptr) {
    std::vector<std::string> known;
    for (const Setting& one : settings()) known.push_back(pathOf(one));
    const std::string nearest = json::nearestWord(path, known);
    return problemAt(
        path, nearest.empty()
                  ? said(TRANSLATE_NOOP("problem", "There is no setting %1."), {path})
                  : said(TRANSLATE_NOOP("problem", "There is no setting %1. Did you mean \"%2\"?"), {path, nearest}));
  }
  const std::vector<std::string> steps = stepsOf(path);
  const std::optional<std::size_t> index = steps.size() > 1 ? numberOfStep(steps[1]) : std::nullopt;
  if (index && *index >= scene.constraints.size())
    return problemAt(path, said(TRANSLATE_NOOP("problem", "The scene has %1 constraints, counted from 0."),
                                {std::to_string(scene.constraints.size())}));
  return problemAt(
      path, said(TRANSLATE_NOOP("problem", "The scene has nothing there with a setting \"%1\"."), {setting->key}));
}

json::Value jsonOf(const SettingValue& value) {
  json::Value made;
  if (const bool* flag = std::get_if<bool>(&value)) {
    made.kind = json::Kind::Bool;
    made.boolean = *flag;
  } else if (const double* number = std::get_if<double>(&value)) {
    made.kind = json::Kind::Number;
    made.number = *number;
  } else if (const auto* word = std::get_if<std::string>(&value)) {
    made.kind = json::Kind::String;
    made.text = *word;
  } else if (const auto* axes = std::get_if<Vec3>(&value)) {
    made.kind = json::Kind::Array;
    for (const double axis : *axes) made.items.push_back(jsonOf(axis));
  }
  return made;
}

/// Sets a value as a file would have it.
class Putting {
 public:
  Putting(const json::Value& value, const std::string& path, Findings& findings)
      : value_(value), path_(path), findings_(findings) {}

  template <class Object>
  void operator()(const SettingOf<Object>& row, Object& into) const {
    if (value_.kind == json::Kind::Null && isNone(row.usual(into))) {
      row.set(into, {});
      return;
    }
    SettingValue value = row.get(into);
    if (!readValue(row.is, value_, path_, value, findings_)) return;
    bool is_good = true;
    valueProblem(row, std::as_const(into), value, [&](const std::string& part, Sentence wrong) {
      findings_.add(value_, path_ + part, std::move(wrong));
      is_good = false;
    });
    if (is_good) row.set(into, value);
  }

  template <class Object>
  void operator()(const SettingOf<Object>& row, std::optional<Object>& into) const {
    if (value_.kind == json::Kind::Null && row.is.said == KeyPresence::Required) {
      into.reset();
    } else if (into) {
      (*this)(row, *into);
    } else {
      (*this)(row, into.emplace());
      for (const SettingOf<Object>& other : rowsOf<Object>()) {
        if (&other != &row) other.set(*into, other.usual(*into));
      }
    }
  }

 private:
  const json::Value& value_;
  const std::string& path_;
  Findings& findings_;
};

Result<Description> withJson(const Description& scene, const std::string& path, const json::Value& value) {
  Description edited = scene;
  Findings findings({});
  if (!inScene(edited, stepsOf(path), Putting(value, path, findings))) return nowhere(scene, path);
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return edited;
}

/// Adds each path of the scene that matches and is a setting.
void addPaths(const Description& scene, const std::vector<std::string>& steps, std::vector<std::string>& paths) {
  const auto star = std::find(steps.begin(), steps.end(), "*");
  if (star == steps.end()) {
    const std::string path = joinedSteps(steps);
    const bool is_new = std::find(paths.begin(), paths.end(), path) == paths.end();
    if (is_new && inScene(scene, steps, [](const auto&, const auto&) {})) paths.push_back(path);
    return;
  }
  const bool is_first = star - steps.begin() == 1;
  const std::size_t count = is_first ? scene.constraints.size() : manipulator::kMaxJoints;
  for (std::size_t index = 0; index < count; ++index) {
    std::vector<std::string> one = steps;
    one[static_cast<std::size_t>(star - steps.begin())] = std::to_string(index);
    addPaths(scene, one, paths);
  }
}

/// Adds each place of the scene that matches the path and has a value.
void addPlaces(const Description& scene, const std::vector<std::string>& steps, std::vector<std::string>& places) {
  const auto star = std::find(steps.begin(), steps.end(), "*");
  if (star == steps.end()) {
    const Result<SettingValue> value = valueAt(scene, joinedSteps(steps));
    if (value && !isNone(value.value())) places.push_back(joinedSteps(steps));
    return;
  }
  const bool is_first = star - steps.begin() == 1;
  const std::size_t count = is_first ? scene.constraints.size() : manipulator::kMaxJoints;
  for (std::size_t index = 0; index < count; ++index) {
    std::vector<std::string> one = steps;
    one[static_cast<std::size_t>(star - steps.begin())] = std::to_string(index);
    addPlaces(scene, one, places);
  }
}

}  // namespace

const std::vector<Setting>& settings() {
  static const std::vector<Setting> kAll = [] {
    std::vector<Setting> all;
    const auto add = [&all](const auto& rows) {
      for (const auto& row : rows) all.push_back(row.is);
    };
    std::apply([&add](const auto&... rows) { (add(rows), ...); }, allRows().rows);
    return all;
  }();
  return kAll;
}

std::string pathOf(const Setting& setting) {
  return std::string(setting.object) + "/" + setting.key;
}

const Setting* findSetting(std::string_view path) {
  std::vector<std::string> steps = stepsOf(path);
  for (std::string& step : steps) {
    if (numberOfStep(step)) step = "*";
  }
  const bool is_of_control = steps.size() > 3 && steps[0] == "constraints" && steps[2] == "control";
  const std::string plain = joinedSteps(Steps(steps).subspan(is_of_control ? 2 : 0));
  const auto found = std::find_if(settings().begin(), settings().end(),
                                  [&](const Setting& setting) { return pathOf(setting) == plain; });
  return found == settings().end() ? nullptr : &*found;
}

Result<Setting> settingAt(const Description& scene, const std::string& path) {
  Setting found{};
  if (!inScene(scene, stepsOf(path), [&found](const auto& row, const auto&) { found = row.is; }))
    return nowhere(scene, path);
  return found;
}

Result<SettingValue> valueAt(const Description& scene, const std::string& path) {
  SettingValue value;
  const auto take = [&value]<class Object>(const SettingOf<Object>& row, const auto& from) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(from)>, Object>)
      value = row.get(from);
    else if (from)
      value = row.get(*from);
  };
  if (!inScene(scene, stepsOf(path), take)) return nowhere(scene, path);
  return value;
}

Result<SettingValue> defaultAt(const Description& scene, const std::string& path) {
  SettingValue value;
  const auto take = [&value]<class Object>(const SettingOf<Object>& row, const auto& from) {
    if (row.is.said == KeyPresence::Required) return;
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(from)>, Object>)
      value = row.usual(from);
    else
      value = row.usual(from ? *from : Object());
  };
  if (!inScene(scene, stepsOf(path), take)) return nowhere(scene, path);
  return value;
}

Result<Description> withValue(const Description& scene, const std::string& path, const SettingValue& value) {
  return withJson(scene, path, jsonOf(value));
}

Result<Description> withFileValue(const Description& scene, const std::string& path, const json::Value& value) {
  return withJson(scene, path, value);
}

bool appliesAt(const Description& scene, const std::string& path) {
  const auto has_own = [](const Constraint& constraint) { return constraint.control.has_value(); };
  if (path.starts_with("/control/") && std::all_of(scene.constraints.begin(), scene.constraints.end(), has_own))
    return false;
  bool applies = false;
  const auto look = [&applies]<class Object>(const SettingOf<Object>& row, const auto& from) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(from)>, Object>)
      applies = row.is_used == nullptr || row.is_used(from);
    else
      applies = from.has_value() && (row.is_used == nullptr || row.is_used(*from));
  };
  return inScene(scene, stepsOf(path), look) && applies;
}

std::vector<std::string> settingPaths(const Description& scene) {
  std::vector<std::string> paths;
  for (const Setting& setting : settings()) {
    const std::string path = pathOf(setting);
    addPaths(scene, stepsOf(path), paths);
    if (path.starts_with("/control/")) addPaths(scene, stepsOf("/constraints/*" + path), paths);
  }
  return paths;
}

Result<Description> withText(const Description& scene, const std::string& given, const std::string& text) {
  const std::string all = given.starts_with('/') ? std::string() : everywhere(given);
  const std::string& path = all.empty() ? given : all;
  const Setting* const setting = findSetting(path);
  if (setting == nullptr) return nowhere(scene, path);
  const bool is_word = setting->kind == SettingKind::Choice;
  const Result<json::Value> parsed = json::parse(text == "none" ? "null" : text, {});
  const json::Value value = parsed && !is_word ? parsed.value() : jsonOf(text);
  std::vector<std::string> places{path};
  if (path.find('*') != std::string::npos) {
    places.clear();
    addPlaces(scene, stepsOf(path), places);
    if (places.empty()) return nowhere(scene, path);
  }
  Description edited = scene;
  for (const std::string& place : places) {
    Result<Description> next = withJson(edited, place, value);
    if (!next) return next;
    edited = std::move(next).value();
  }
  return edited;
}

std::string everywhere(std::string_view key) {
  for (const Setting& setting : settings()) {
    if (key != setting.key) continue;
    const std::string path = pathOf(setting);
    return path.starts_with("/control/") ? "/constraints/*" + path : path;
  }
  return {};
}

std::string controlPath(const Description& scene, std::size_t index) {
  const bool only_one = scene.constraints.size() == 1 && !scene.constraints[index].control;
  return only_one ? "/control" : "/constraints/" + std::to_string(index) + "/control";
}

}  // namespace underact::scene
