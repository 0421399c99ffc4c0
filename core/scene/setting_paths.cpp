// Settings by their paths.
#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/base/translate.h"
#include "core/scene/all_settings.h"
#include "core/scene/setting_rows.h"
#include "core/scene/setting_visit.h"

namespace underact::scene {
namespace {

constexpr int kMaxRounds = 8;  // values that allow one another in a longer row do not exist

Problems problemAt(const std::string& path, Sentence sentence) {
  return {{std::move(sentence), {{}, 0, 0, path}}};
}

/// The problem of a path without a setting in the scene. has_hint: it names the nearest path, which takes long.
Problems nowhere(const Description& scene, const std::string& path, bool has_hint = true) {
  const Setting* const setting = findSetting(path);
  if (setting == nullptr) {
    std::vector<std::string> known;
    for (std::size_t index = 0; has_hint && index < settings().size(); ++index)
      known.push_back(pathOf(settings()[index]));
    const std::string nearest = json::nearestWord(path, known);
    return problemAt(
        path, nearest.empty()
                  ? phrase(TRANSLATE_NOOP("problem", "There is no setting %1."), {path})
                  : phrase(TRANSLATE_NOOP("problem", "There is no setting %1. Did you mean \"%2\"?"), {path, nearest}));
  }
  const std::vector<std::string> steps = stepsOf(path);
  const std::optional<std::size_t> index = steps.size() > 1 ? numberOfStep(steps[1]) : std::nullopt;
  if (index && *index >= scene.constraints.size())
    return problemAt(path, phrase(TRANSLATE_NOOP("problem", "The scene has %1 constraints, counted from 0."),
                                  {std::to_string(scene.constraints.size())}));
  return problemAt(
      path, phrase(TRANSLATE_NOOP("problem", "The scene has nothing there with a setting \"%1\"."), {setting->key}));
}

json::Value jsonOf(const SettingValue& value) {
  json::Value made;
  if (const bool* flag = std::get_if<bool>(&value)) {
    made.kind = json::JsonKind::Bool;
    made.boolean = *flag;
  } else if (const double* number = std::get_if<double>(&value)) {
    made.kind = json::JsonKind::Number;
    made.number = *number;
  } else if (const auto* word = std::get_if<std::string>(&value)) {
    made.kind = json::JsonKind::String;
    made.text = *word;
  } else if (const auto* axes = std::get_if<Vec3>(&value)) {
    made.kind = json::JsonKind::Array;
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
    if (value_.kind == json::JsonKind::Null && isNone(row.default_value(into))) {
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
    if (value_.kind == json::JsonKind::Null && row.is.given == KeyPresence::Required) {
      into.reset();
    } else if (into) {
      (*this)(row, *into);
    } else {
      (*this)(row, into.emplace());
      for (const SettingOf<Object>& other : rowsOf<Object>()) {
        if (&other != &row) other.set(*into, other.default_value(*into));
      }
    }
  }

 private:
  const json::Value& value_;
  const std::string& path_;
  Findings& findings_;
};

/// Puts a value into the scene. Problems: those of the value or the path; then the scene is as it was.
Problems put(Description& scene, const std::string& path, const json::Value& value, bool has_hint = true) {
  const std::vector<std::string> steps = stepsOf(path);
  if (!inScene(std::as_const(scene), steps, [](const auto&, const auto&) {})) return nowhere(scene, path, has_hint);
  // What is made for the value, such as a control of its own, must not stay without it.
  const std::optional<std::size_t> index = steps[0] == "constraints" ? numberOfStep(steps[1]) : std::nullopt;
  std::optional<Constraint> before;
  if (index) before = scene.constraints[*index];
  Findings findings({});
  inScene(scene, steps, Putting(value, path, findings));
  Problems problems = findings.take();
  if (!problems.empty() && before) scene.constraints[*index] = std::move(*before);
  return problems;
}

Result<Description> withJson(const Description& scene, const std::string& path, const json::Value& value) {
  Description edited = scene;
  Problems problems = put(edited, path, value);
  if (!problems.empty()) return problems;
  return edited;
}

/// Adds each path of the scene that matches and is a setting.
void addPaths(const Description& scene, const std::vector<std::string>& steps, std::unordered_set<std::string>& seen,
              std::vector<std::string>& paths) {
  const auto star = std::find(steps.begin(), steps.end(), "*");
  if (star == steps.end()) {
    const std::string path = joinedSteps(steps);
    if (inScene(scene, steps, [](const auto&, const auto&) {}) && seen.insert(path).second) paths.push_back(path);
    return;
  }
  const bool is_first = star - steps.begin() == 1;
  const std::size_t count = is_first ? scene.constraints.size() : manipulator::kMaxJoints;
  for (std::size_t index = 0; index < count; ++index) {
    std::vector<std::string> one = steps;
    one[static_cast<std::size_t>(star - steps.begin())] = std::to_string(index);
    addPaths(scene, one, seen, paths);
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
  static const std::unordered_map<std::string, const Setting*> kByPath = [] {
    std::unordered_map<std::string, const Setting*> by_path;
    for (const Setting& setting : settings()) by_path.emplace(pathOf(setting), &setting);
    return by_path;
  }();
  const auto found = kByPath.find(plain);
  return found == kByPath.end() ? nullptr : found->second;
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
    if (row.is.given == KeyPresence::Required) return;
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(from)>, Object>)
      value = row.default_value(from);
    else
      value = row.default_value(from ? *from : Object());
  };
  if (!inScene(scene, stepsOf(path), take)) return nowhere(scene, path);
  return value;
}

Result<Description> withValue(const Description& scene, const std::string& path, const SettingValue& value) {
  return withJson(scene, path, jsonOf(value));
}

Result<Description> withFileValues(const Description& scene, const json::Value& values, std::size_t max_problems,
                                   std::size_t max_hints) {
  Description edited = scene;
  std::vector<std::size_t> left(values.keys.size());
  for (std::size_t index = 0; index < left.size(); ++index) left[index] = index;
  Problems problems;
  std::size_t before = left.size() + 1;
  // One value may allow another, as the greater static friction the greater dynamic one: they have no order.
  for (int round = 0; round < kMaxRounds && !left.empty() && left.size() < before; ++round) {
    before = left.size();
    problems.clear();
    std::vector<std::size_t> again;
    for (const std::size_t index : left) {
      const std::string& path = values.keys[index];
      const bool has_room = problems.size() < max_problems;
      for (Problem& problem : put(edited, path, values.items[index], problems.size() < max_hints)) {
        if (problem.place.key.empty()) problem.place.key = path;
        if (again.empty() || again.back() != index) again.push_back(index);
        if (has_room) problems.push_back(std::move(problem));
      }
      if (!has_room && findSetting(path) == nullptr) return problems;  // which no other value allows
    }
    left = std::move(again);
  }
  if (!left.empty()) return problems;
  return edited;
}

bool hasSetting(const Description& scene, const std::string& path) {
  return inScene(scene, stepsOf(path), [](const auto&, const auto&) {});
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
  std::unordered_set<std::string> seen;
  for (const Setting& setting : settings()) {
    const std::string path = pathOf(setting);
    addPaths(scene, stepsOf(path), seen, paths);
    if (path.starts_with("/control/")) addPaths(scene, stepsOf("/constraints/*" + path), seen, paths);
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
