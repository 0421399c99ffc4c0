// The table of settings, held against what reads and writes scenes, and against the schema.
#include "core/scene/settings.h"

#include <cmath>
#include <set>

#include "core/scene/setting_rows.h"
#include "core/scene/write.h"
#include "tests/core/scene/scene_support.h"

namespace underact::scene {
namespace {

/// All that there is: each filter, a joint that slides, a curve that leads.
constexpr const char* kEverything =
    R"({"underact_scene": 1, "title": "t", "control": {"law": "PID", "kp_N_per_mm": 0.4},
  "constraints": [
    {"type": "point", "position_mm": [0, 0, 0], "control": {"law": "PD", "velocity": {"filter": "low_pass"}}},
    {"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 9, "influence": {"t": 0.25}, "friction": {"static": 0.4}},
    {"type": "plane", "point_mm": [0, 0, 0], "normal": [0, 1, 0], "side": "outside",
     "control": {"law": "PID", "velocity": {"filter": "adaptive_window"}}},
    {"type": "curve", "file": "a.txt", "guide": {"speed_mm_per_s": 30}, "control": {"velocity": {"filter": "raw"}}},
    {"type": "mesh", "file": "a.stl", "search": "global"},
    {"type": "virtual_manipulator", "orientation": "full", "ko_N_mm_per_rad": 3, "joints": [
      {"type": "revolute", "axis": [0, 0, 1], "point_mm": [0, 0, 0], "stiffness_N_mm_per_rad": 2, "max": 1},
      {"type": "prismatic", "axis": [1, 0, 0], "min": -4, "stiffness_N_per_mm": 2, "rest": 1}],
     "X_WV_home": [[1, 0, 0, 9], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]})";

std::vector<Description> scenesWithSettings() {
  std::vector<Description> all{readScene(kEverything, "").value()};
  for (const std::filesystem::path& file : test::sceneFiles()) all.push_back(readSceneFile(file.string()).value());
  return all;
}

/// Every place of the scene that the row is of, a value there or not.
std::vector<std::string> whereIn(const Description& scene, const Setting& setting) {
  std::vector<std::string> found, open{pathOf(setting)};
  if (open[0].starts_with("/control")) open.push_back("/constraints/*" + open[0]);
  while (!open.empty()) {
    const std::string path = open.back();
    open.pop_back();
    const std::size_t star = path.find('*');
    for (int number = 0; star != std::string::npos && number < 12; ++number)
      open.push_back(std::string(path).replace(star, 1, std::to_string(number)));
    if (star == std::string::npos && valueAt(scene, path)) found.push_back(path);
  }
  return found;
}

/// Where the pointer leads in the text; null: to nothing.
const json::Value* inJson(const json::Value& root, const std::string& path) {
  const json::Value* at = &root;
  for (std::size_t from = 1; at != nullptr && from <= path.size();) {
    const std::size_t end = std::min(path.find('/', from), path.size());
    const std::string step = path.substr(from, end - from);
    from = end + 1;
    if (at->kind == json::JsonKind::Array)
      at = std::stoul(step) < at->items.size() ? &at->items[std::stoul(step)] : nullptr;
    else
      at = at->find(step);
  }
  return at;
}

/// The text with another value there; empty: without the key.
std::string replaced(const std::string& text, const std::string& path, const std::string& value) {
  const json::Value root = json::parse(text, "").value();
  const json::Value& there = *inJson(root, path);
  std::size_t at = 0;
  for (int line = 1; line < there.line; ++line) at = text.find('\n', at) + 1;
  for (int column = 1; column < there.column; ++at) column += (text[at + 1] & 0xC0) != 0x80;
  std::size_t end = at;
  for (int depth = 0; depth > 0 || std::string(",}\n").find(text[end]) == std::string::npos; ++end)
    depth += text[end] == '[' ? 1 : text[end] == ']' ? -1 : 0;
  if (!value.empty()) return std::string(text).replace(at, end - at, value);
  const std::size_t key = text.rfind('"', text.rfind('"', at) - 1);
  const bool is_last = text[end] != ',';
  const std::size_t from = is_last ? std::min(key, text.find_last_not_of(" \n", key - 1)) : key;
  const std::size_t to = is_last ? end : end + 1;
  const bool is_only = is_last && text[from] == '{';
  return std::string(text).replace(is_only ? from + 1 : from, to - (is_only ? from + 1 : from), "");
}

/// Another value that the row allows.
SettingValue otherValue(const Setting& setting, const SettingValue& now) {
  if (setting.kind == SettingKind::Choice) {
    const std::vector<std::string> words = setting.words();
    return words.front() == std::get<std::string>(now) ? words.back() : words.front();
  }
  if (setting.kind == SettingKind::Flag) return !std::get<bool>(now);
  if (setting.kind == SettingKind::Whole) return 17.0;
  if (setting.kind == SettingKind::Gain) return Vec3(0.25, 0.5, 0.75);
  return std::isfinite(setting.min) ? setting.min + 0.0625 * std::min(setting.max - setting.min, 4.0) : 0.5;
}

std::string pathInSentences(const std::string& path) {
  std::string dotted;
  for (std::size_t from = 1; from <= path.size();) {
    const std::size_t end = std::min(path.find('/', from), path.size());
    const std::string step = path.substr(from, end - from);
    dotted += std::isdigit(static_cast<unsigned char>(step[0])) ? "[" + step + "]" : (dotted.empty() ? "" : ".") + step;
    from = end + 1;
  }
  return dotted;
}

class EverySetting : public ::testing::Test {
 protected:
  /// Calls look(scene, setting, path) for each place in the scenes.
  template <class Look>
  void each(const Look& look) {
    std::set<std::string> seen;
    for (const Description& scene : scenesWithSettings()) {
      for (const Setting& setting : settings()) {
        for (const std::string& path : whereIn(scene, setting)) {
          SCOPED_TRACE(scene.file + path);
          seen.insert(pathOf(setting));
          look(scene, settingAt(scene, path).value(), path);
        }
      }
    }
    for (const Setting& setting : settings()) EXPECT_TRUE(seen.count(pathOf(setting))) << pathOf(setting);
  }
};

TEST_F(EverySetting, IsWhatItWasSetTo) {
  each([](const Description& scene, const Setting& setting, const std::string& path) {
    const SettingValue now = valueAt(scene, path).value();
    if (!isNone(now)) {
      const Result<Description> same = withValue(scene, path, now);
      ASSERT_TRUE(same) << same.problems().front().sentence;
      EXPECT_TRUE(test::same(controlPath(scene, 0) == "/control" ? scene : same.value(), same.value()) ||
                  path.find("control") != std::string::npos);
    }
    if (isNone(now) && setting.kind == SettingKind::Choice) return;
    const SettingValue other = otherValue(setting, now);
    const Result<Description> edited = withValue(scene, path, other);
    if (!edited && setting.key == std::string("dynamic")) return;  // it depends on the static share
    ASSERT_TRUE(edited) << edited.problems().front().sentence;
    EXPECT_EQ(valueAt(edited.value(), path).value(), other);
  });
}

TEST_F(EverySetting, StandsInTheFileWhereItsPathSays) {
  each([](const Description& scene, const Setting& setting, const std::string& path) {
    const SettingValue now = valueAt(scene, path).value();
    if (isNone(now) && setting.kind == SettingKind::Choice) return;
    const Result<Description> edited = withValue(scene, path, otherValue(setting, now));
    if (!edited) return;
    const SettingValue value = valueAt(edited.value(), path).value();
    const json::Value root = json::parse(writeScene(edited.value()), "").value();
    const json::Value* const there = inJson(root, path);
    if (there == nullptr) {
      const bool is_default =
          setting.given == KeyPresence::Required || defaultAt(edited.value(), path).value() == value;
      EXPECT_TRUE(is_default);  // the filter is required of a velocity, and that is left out where it is the usual one
      return;
    }
    const std::string text = fileTextOf(value);
    const std::string written = there->kind == json::JsonKind::Number   ? json::numberText(there->number)
                                : there->kind == json::JsonKind::Bool   ? (there->boolean ? "true" : "false")
                                : there->kind == json::JsonKind::String ? json::quotedText(there->text)
                                                                        : text;
    EXPECT_EQ(written, text);
    if (!check(edited.value()).empty()) return;
    const Result<Description> read = readScene(writeScene(edited.value()), "");
    ASSERT_TRUE(read) << describe(read.problems().front());
    EXPECT_EQ(valueAt(read.value(), path).value(), value);
  });
}

TEST_F(EverySetting, LeftOutIsWhatTheTableSays) {
  each([](const Description& scene, const Setting& setting, const std::string& path) {
    const std::string text = writeScene(scene);
    const json::Value root = json::parse(text, "").value();
    if (inJson(root, path) == nullptr) {
      const std::string object = path.substr(0, path.rfind('/'));
      if (object.empty() || inJson(root, object) != nullptr) {
        EXPECT_EQ(valueAt(scene, path).value(), defaultAt(scene, path).value());
      }
      return;
    }
    const Result<Description> read = readScene(replaced(text, path, ""), "");
    if (setting.given == KeyPresence::Required) {
      ASSERT_FALSE(read);
      EXPECT_NE(read.problems().front().sentence.find("is missing"), std::string::npos);
    } else if (read) {  // what is between keys may refuse it
      EXPECT_EQ(valueAt(read.value(), path).value(), defaultAt(scene, path).value());
    }
  });
}

TEST_F(EverySetting, OutOfItsRangeIsRefusedByWhomeverItIsSet) {
  each([](const Description& scene, const Setting& setting, const std::string& path) {
    if (setting.kind == SettingKind::Choice || setting.kind == SettingKind::Flag) return;
    std::vector<double> wrong{std::nextafter(setting.max, kInfinity), std::nextafter(setting.min, -kInfinity)};
    if (setting.is_above_min) wrong.back() = setting.min;
    if (setting.kind == SettingKind::Whole) wrong = {setting.max + 1.0, setting.min - 1.0, setting.min + 0.5};
    if (!std::isfinite(setting.min)) wrong = {1e7};  // of a joint: rad, or mm
    const json::Value root = json::parse(writeScene(scene), "").value();
    for (const double number : wrong) {
      const Result<Description> set = withValue(scene, path, number);
      ASSERT_FALSE(set) << number;
      EXPECT_EQ(set.problems().front().place.key, path);
      if (inJson(root, path) == nullptr) continue;
      const Result<Description> read = readScene(replaced(writeScene(scene), path, json::numberText(number)), "");
      ASSERT_FALSE(read) << number;
      const std::string key = pathInSentences(path);
      const auto is_of_it = [&](const Problem& problem) {
        return problem.place.key == key && problem.sentence == set.problems().front().sentence;
      };
      EXPECT_TRUE(std::any_of(read.problems().begin(), read.problems().end(), is_of_it)) << number;
    }
  });
}

TEST(Setting, IsFoundByItsPathAndByItsPattern) {
  EXPECT_EQ(findSetting("/constraints/12/influence/t"), findSetting("/constraints/*/influence/t"));
  EXPECT_EQ(findSetting("/constraints/0/control/law"), findSetting("/control/law"));
  EXPECT_EQ(findSetting("/constraints/3/joints/1/min"), findSetting("/constraints/*/joints/*/min"));
  EXPECT_EQ(findSetting("/control/laws"), nullptr);
  EXPECT_EQ(findSetting("control/law"), nullptr);
  EXPECT_EQ(findSetting(""), nullptr);
  EXPECT_EQ(everywhere("law"), "/constraints/*/control/law");
  EXPECT_EQ(everywhere("t"), "/constraints/*/influence/t");
  EXPECT_EQ(everywhere("title"), "");
}

TEST(Setting, NamesASettingThatDoesNotExist) {
  const Description scene = readScene(kEverything, "").value();
  const auto wrong = [&](const std::string& path, const std::string& text) {
    return std::string(withText(scene, path, text).problems().front().sentence);
  };
  EXPECT_EQ(wrong("/control/lawn", "P"), "There is no setting /control/lawn. Did you mean \"/control/law\"?");
  EXPECT_EQ(wrong("title", "x"), "There is no setting title.");
  EXPECT_EQ(wrong("/constraints/6/control/law", "P"), "The scene has 6 constraints, counted from 0.");
  EXPECT_EQ(wrong("/constraints/0/influence/t", "0.5"), "The scene has nothing there with a setting \"t\".");
  EXPECT_EQ(wrong("/control/law", "PI"), "This must be \"P\", \"PD\" or \"PID\"; here it is \"PI\".");
  EXPECT_EQ(wrong("/control/kp_N_per_mm", "much"),
            "This must be a number, or a list of 3 numbers for x, y and z; here it is text.");
  EXPECT_EQ(wrong("/constraints/4/smooth_deg", "none"), "This must be a number; here it is null.");
}

TEST(Setting, TextsAreThoseOfFiles) {
  const Description scene = readScene(kEverything, "").value();
  const auto set = [&](const std::string& path, const std::string& text, const std::string& look) {
    return fileTextOf(valueAt(withText(scene, path, text).value(), look).value());
  };
  EXPECT_EQ(set("/control/law", "PD", "/constraints/1/control/law"), "\"PD\"");
  EXPECT_EQ(set("/control/kp_N_per_mm", "[1, 2, 3]", "/control/kp_N_per_mm"), "[1, 2, 3]");
  EXPECT_EQ(set("/constraints/3/closed", "true", "/constraints/3/closed"), "true");
  EXPECT_EQ(set("/constraints/5/orientation", "none", "/constraints/5/orientation"), "\"none\"");
  EXPECT_EQ(set("/constraints/5/joints/0/max", "none", "/constraints/5/joints/0/max"), "null");
  EXPECT_EQ(set("/constraints/*/control/kp_N_per_mm", "2", "/constraints/5/control/kp_N_per_mm"), "2");
  EXPECT_EQ(set("kp_N_per_mm", "2", "/constraints/0/control/kp_N_per_mm"), "2");
  EXPECT_EQ(set("/constraints/*/influence/t", "1", "/constraints/1/influence/t"), "1");
  EXPECT_EQ(set("/constraints/1/influence/t", "none", "/constraints/1/influence/blend_deg"), "null");
}

TEST(Setting, MakesAnAbsentPartWithDefaults) {
  const Description scene =
      readScene(test::sceneWith(R"({"type": "line", "point_mm": [0, 0, 0], "direction": [1, 0, 0]})"), "").value();
  const Description rough = withValue(scene, "/constraints/0/friction/static", 0.4).value();
  EXPECT_EQ(rough.constraints[0].friction, (Friction{0.4, 0.4}));
  EXPECT_EQ(withValue(rough, "/constraints/0/friction/static", {}).value().constraints[0].friction, std::nullopt);
}

// The schema is for editors; here it is held against the table.

const json::Value& resolved(const json::Value& root, const json::Value& node) {
  const json::Value* const ref = node.find("$ref");
  return ref == nullptr ? node : *root.find("$defs")->find(ref->text.substr(std::string("#/$defs/").size()));
}

/// Each place of the schema that describes the setting.
std::vector<const json::Value*> inSchema(const json::Value& root, const Setting& setting) {
  const std::string object = setting.object;
  const std::string last = object.substr(object.rfind('/') + 1);
  const json::Value& defs = *root.find("$defs");
  std::vector<const json::Value*> objects;
  if (object.empty()) objects = {&root};
  if (object == "/simulation") objects = {root.find("properties")->find("simulation")};
  if (last == "*" && object == "/constraints/*") {
    for (const json::Value& type : root.find("properties")->find("constraints")->find("items")->find("oneOf")->items)
      objects.push_back(&resolved(root, type));
  }
  if (last == "velocity") {
    for (const json::Value& one : defs.find("velocity")->find("oneOf")->items) objects.push_back(&one);
  }
  if (object.ends_with("/joints/*")) objects = {defs.find("joint")};
  if (objects.empty()) objects = {defs.find(last == "guide" ? "curve_guide" : last)};
  std::vector<const json::Value*> found;
  for (const json::Value* one : objects) {
    if (const json::Value* key = one->find("properties")->find(setting.key)) found.push_back(key);
  }
  return found;
}

template <class Object>
std::string defaultTextOf(const SettingOf<Object>& row) {
  return fileTextOf(row.default_value(Object{}));
}

std::string schemaText(const json::Value& value) {
  if (value.kind == json::JsonKind::String) return json::quotedText(value.text);
  if (value.kind == json::JsonKind::Bool) return value.boolean ? "true" : "false";
  return json::numberText(value.number);
}

template <class Object>
void holdAgainstSchema(const json::Value& root, const SettingOf<Object>& row) {
  SCOPED_TRACE(pathOf(row.is));
  const auto places = inSchema(root, row.is);
  ASSERT_FALSE(places.empty());
  bool has_range = false, has_words = false;
  for (const json::Value* place : places) {
    const json::Value* is = &resolved(root, *place);
    if (row.is.kind == SettingKind::Gain) is = &resolved(root, is->find("oneOf")->items[0]);
    const json::Value* default_value = place->find("default") != nullptr ? place->find("default") : is->find("default");
    const json::Value* const words = is->find("enum");
    if (row.is.kind == SettingKind::Choice && words == nullptr) continue;  // filter: a const in each
    if (words != nullptr) {
      std::set<std::string> known, given;
      for (const json::Value& word : words->items) given.insert(word.text);
      for (const std::string& word : row.is.words()) known.insert(word);
      EXPECT_EQ(given, known);
      has_words = true;
    }
    const json::Value* const min = is->find(row.is.is_above_min ? "exclusiveMinimum" : "minimum");
    const json::Value* const max = is->find("maximum");
    has_range = has_range ||
                (min == nullptr ? !std::isfinite(row.is.min) : min->number == row.is.min && max->number == row.is.max);
    if (row.is.kind == SettingKind::Whole) {
      EXPECT_EQ(is->find("type")->text, "integer");
    }
    const bool has_default = row.is.given != KeyPresence::Required && !isNone(row.default_value(Object{})) &&
                             row.is.key != std::string("dynamic");
    ASSERT_EQ(default_value != nullptr, has_default);
    if (places.size() == 1 && default_value != nullptr) {
      EXPECT_EQ(schemaText(*default_value), defaultTextOf(row));
    }
  }
  if (row.is.kind != SettingKind::Choice) {
    EXPECT_TRUE(has_range);
  }
  EXPECT_EQ(has_words, row.is.kind == SettingKind::Choice && row.is.key != std::string("filter"));
}

TEST(SceneSchema, SaysOfEachSettingWhatTheTableSays) {
  const std::string path = std::string(UNDERACT_SOURCE) + "/scenes/scene.schema.json";
  const json::Value root = json::parse(test::fileText(path), path).value();
  std::apply(
      [&](const auto&... rows) {
        const auto all = [&](const auto& of_one) {
          for (const auto& row : of_one) holdAgainstSchema(root, row);
        };
        (all(rows), ...);
      },
      allRows().rows);
}

}  // namespace
}  // namespace underact::scene
