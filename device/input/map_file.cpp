#include "device/input/map_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/json/object_reader.h"
#include "core/json/text.h"

namespace underact::device::input {
namespace {

using json::Findings;
using json::ObjectReader;
using json::Value;

constexpr std::array kMotionAxisNames{"right", "up", "near", "turn_x", "turn_y", "turn_z"};
constexpr std::array kPressNames{"stylus_1", "stylus_2", "stop"};
constexpr const char* kMap = TRANSLATE_NOOP("problem", "a mapping");
constexpr std::size_t kLargest = std::size_t{1} << 20;

bool isTurn(std::size_t motion) {
  return motion >= kMoves;
}

/// The unit of a direction's top speed in the file.
double unitOf(std::size_t motion) {
  return isTurn(motion) ? kRadPerDegree : kMetrePerMillimetre;
}

void readWithin(ObjectReader& object, const char* key, double min, double max, double& into) {
  const Value* const value = object.find(key);
  if (value == nullptr) return;
  double number = into;
  json::readNumber(*value, object.pathOf(key), number, object.findings());
  if (std::isnan(number)) return;  // not a number at all, and reported
  if (number >= min && number <= max) {
    into = number;
    return;
  }
  object.findings().add(*value, object.pathOf(key),
                        phrase(TRANSLATE_NOOP("problem", "This must lie between %1 and %2."),
                               {json::numberText(min), json::numberText(max)}));
}

/// false, and a problem: it is not a number from 0 to most - 1.
bool readIndex(const Value& value, const std::string& path, int max, int& into, Findings& findings) {
  if (!json::isKind(value, json::JsonKind::Number, path, phrase(TRANSLATE_NOOP("problem", "a number, as in 0")),
                    findings))
    return false;
  const bool is_one = value.number >= 0.0 && value.number < max && value.number == std::floor(value.number);
  if (is_one)
    into = static_cast<int>(value.number);
  else
    findings.add(
        value, path,
        phrase(TRANSLATE_NOOP("problem", "This must be a whole number from 0 to %1."), {std::to_string(max - 1)}));
  return is_one;
}

/// [positive, negative], each a number or null.
void readPair(const Value& value, const std::string& path, int max, Source& source, Findings& findings) {
  if (!json::isKind(value, json::JsonKind::Array, path,
                    phrase(TRANSLATE_NOOP("problem", "a list of two, as in [4, 5]")), findings))
    return;
  if (value.items.size() != 2) {
    findings.add(value, path,
                 phrase(TRANSLATE_NOOP(
                     "problem", "This must be a list of two: one for the positive direction, one for the negative.")));
    return;
  }
  const std::array<int*, 2> parts{&source.plus, &source.minus};
  for (std::size_t part = 0; part < 2; ++part) {
    if (value.items[part].kind == json::JsonKind::Null) continue;
    readIndex(value.items[part], path + "[" + std::to_string(part) + "]", max, *parts[part], findings);
  }
}

void readSource(ObjectReader& object, const Value& all, Source& source) {
  Findings& findings = object.findings();
  int kinds = 0;
  if (const Value* const axis = object.find("axis")) {
    ++kinds;
    source.kind = SourceKind::Axis;
    readIndex(*axis, object.pathOf("axis"), kMaxAxes, source.plus, findings);
  }
  if (const Value* const buttons = object.find("buttons")) {
    ++kinds;
    source = {SourceKind::Buttons, -1, -1};
    readPair(*buttons, object.pathOf("buttons"), kMaxButtons, source, findings);
  }
  if (const Value* const triggers = object.find("triggers")) {
    ++kinds;
    source = {SourceKind::Triggers, -1, -1};
    readPair(*triggers, object.pathOf("triggers"), kMaxAxes, source, findings);
  }
  if (kinds > 1)
    findings.add(all, object.pathOf("axis"),
                 phrase(TRANSLATE_NOOP("problem", "Give only one of \"axis\", \"buttons\" and \"triggers\".")));
}

AxisMap readMotionAxis(const Value& value, const std::string& path, std::size_t motion, Findings& findings) {
  AxisMap map;
  if (!json::isKind(value, json::JsonKind::Object, path,
                    phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"axis\": 0}"}), findings))
    return map;
  ObjectReader object(value, path, phrase(TRANSLATE_NOOP("problem", "a direction")), findings);
  readSource(object, value, map.source);
  if (const Value* const inverted = object.find("inverted")) {
    const std::string at = object.pathOf("inverted");
    if (json::isKind(*inverted, json::JsonKind::Bool, at, phrase(TRANSLATE_NOOP("problem", "true or false")), findings))
      map.inverted = inverted->boolean;
  }
  readWithin(object, "dead_zone", 0.0, kFurthestDeadZone, map.dead_zone);
  readWithin(object, "exponent", 1.0, kFinest, map.exponent);
  const double fastest =
      isTurn(motion) ? std::round(kFastest_rad_per_s / unitOf(motion)) : kFastest_m_per_s / unitOf(motion);
  double top = 0.0;
  readWithin(object, isTurn(motion) ? "top_deg_per_s" : "top_mm_per_s", 0.0, fastest, top);
  map.top = top * unitOf(motion);
  object.finish();
  return map;
}

void readMotionAxes(const Value& value, Map& map, Findings& findings) {
  if (!json::isKind(value, json::JsonKind::Object, "ways",
                    phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"right\": {\"axis\": 0}}"}), findings))
    return;
  ObjectReader object(value, "ways", phrase(TRANSLATE_NOOP("problem", "a mapping")), findings);
  for (std::size_t motion = 0; motion < kMotionAxes; ++motion) {
    if (const Value* const one = object.find(kMotionAxisNames[motion]))
      map.motions[motion] = readMotionAxis(*one, object.pathOf(kMotionAxisNames[motion]), motion, findings);
  }
  object.finish();
}

void readPresses(const Value& value, Map& map, Findings& findings) {
  if (!json::isKind(value, json::JsonKind::Object, "buttons",
                    phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"stop\": 1}"}), findings))
    return;
  ObjectReader object(value, "buttons", phrase(TRANSLATE_NOOP("problem", "the buttons of a mapping")), findings);
  for (std::size_t press = 0; press < kPresses; ++press) {
    if (const Value* const one = object.find(kPressNames[press]))
      readIndex(*one, object.pathOf(kPressNames[press]), kMaxButtons, map.presses[press], findings);
  }
  object.finish();
}

std::string indexText(int index) {
  return index < 0 ? "null" : std::to_string(index);
}

std::string sourceMember(const Source& source) {
  const std::string pair = "[" + indexText(source.plus) + ", " + indexText(source.minus) + "]";
  switch (source.kind) {
    case SourceKind::None:
      return {};
    case SourceKind::Axis:
      return "\"axis\": " + std::to_string(source.plus) + ", ";
    case SourceKind::Buttons:
      return "\"buttons\": " + pair + ", ";
    case SourceKind::Triggers:
      return "\"triggers\": " + pair + ", ";
  }
  return {};
}

std::string wayText(const AxisMap& map, std::size_t motion) {
  return "{" + sourceMember(map.source) + "\"inverted\": " + (map.inverted ? "true" : "false") +
         ", \"dead_zone\": " + json::numberText(map.dead_zone) + ", \"exponent\": " + json::numberText(map.exponent) +
         (isTurn(motion) ? ", \"top_deg_per_s\": " : ", \"top_mm_per_s\": ") +
         json::numberText(map.top / unitOf(motion)) + "}";
}

}  // namespace

const char* motionAxisName(MotionAxis motion) {
  return kMotionAxisNames[static_cast<std::size_t>(motion)];
}

const char* pressName(ButtonRole press) {
  return kPressNames[static_cast<std::size_t>(press)];
}

Result<MapFile> readMap(std::string_view text, const std::string& file_name) {
  const Result<Value> root = json::parse(text, file_name);
  if (!root) return root.problems();
  Findings findings(file_name);
  MapFile file;
  if (json::isKind(root.value(), json::JsonKind::Object, "",
                   phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"underact_hand_map\": 1, ...}"}),
                   findings)) {
    ObjectReader object(root.value(), "", phrase(kMap), findings);
    if (const Value* const version = object.find("underact_hand_map", true)) {
      double number = 1.0;
      json::readNumber(*version, "underact_hand_map", number, findings);
      if (number != 1.0)
        findings.add(*version, "underact_hand_map",
                     phrase(TRANSLATE_NOOP("problem", "This program reads version 1 only.")));
    }
    if (const Value* const device = object.find("device")) json::readText(*device, "device", file.device, findings);
    if (const Value* const id = object.find("id", true)) json::readText(*id, "id", file.id, findings);
    if (const Value* const motions = object.find("ways", true)) readMotionAxes(*motions, file.map, findings);
    if (const Value* const buttons = object.find("buttons")) readPresses(*buttons, file.map, findings);
    object.finish();
  }
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return file;
}

Result<MapFile> readMapFile(const std::string& path) {
  const Result<std::string> text = json::readTextFile(path, phrase(kMap), kLargest);
  if (!text) return text.problems();
  return readMap(text.value(), path);
}

std::string mapText(const MapFile& file) {
  std::string text = "{\n  \"underact_hand_map\": 1,\n  \"device\": " + json::quotedText(file.device) +
                     ",\n  \"id\": " + json::quotedText(file.id) + ",\n  \"ways\": {";
  for (std::size_t motion = 0; motion < kMotionAxes; ++motion) {
    text += std::string(motion == 0 ? "" : ",") + "\n    \"" + kMotionAxisNames[motion] +
            "\": " + wayText(file.map.motions[motion], motion);
  }
  text += "\n  },\n  \"buttons\": {";
  const char* between = "";
  for (std::size_t press = 0; press < kPresses; ++press) {
    if (file.map.presses[press] < 0) continue;
    text += std::string(between) + "\"" + kPressNames[press] + "\": " + std::to_string(file.map.presses[press]);
    between = ", ";
  }
  return text + "}\n}\n";
}

std::string sourceText(const Source& source) {
  const auto pair = [&](const char* what) {
    return what + std::to_string(source.plus) + " " + std::to_string(source.minus);
  };
  switch (source.kind) {
    case SourceKind::None:
      break;
    case SourceKind::Axis:
      return "axis " + std::to_string(source.plus);
    case SourceKind::Buttons:
      return pair("buttons ");
    case SourceKind::Triggers:
      return pair("triggers ");
  }
  return "nothing";
}

std::optional<Source> sourceOf(std::string_view text) {
  if (text == "nothing") return Source{};
  const std::size_t space = text.find(' ');
  if (space == std::string_view::npos) return {};
  const std::string_view word = text.substr(0, space);
  Source source;
  source.kind = word == "axis"       ? SourceKind::Axis
                : word == "buttons"  ? SourceKind::Buttons
                : word == "triggers" ? SourceKind::Triggers
                                     : SourceKind::None;
  const int max = source.kind == SourceKind::Buttons ? kMaxButtons : kMaxAxes;
  const char* const end = text.data() + text.size();
  std::from_chars_result read = std::from_chars(text.data() + space + 1, end, source.plus);
  if (source.kind == SourceKind::None || read.ec != std::errc()) return {};
  if (source.kind != SourceKind::Axis) {
    if (read.ptr == end || *read.ptr != ' ') return {};
    read = std::from_chars(read.ptr + 1, end, source.minus);
  }
  const int min = source.kind == SourceKind::Axis ? 0 : -1;
  if (read.ec != std::errc() || read.ptr != end || source.plus < min || source.plus >= max || source.minus < -1 ||
      source.minus >= max)
    return {};
  return source;
}

}  // namespace underact::device::input
