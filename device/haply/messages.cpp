#include "device/haply/messages.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/json/json.h"
#include "core/json/object_text.h"

namespace underact::device::haply {
namespace {

constexpr double kFarthest_m = 10.0;  // no arm reaches so far: such a place is a broken message
constexpr std::size_t kLongestWord = 100;

const json::Value* memberOf(const json::Value* value, std::string_view key, json::JsonKind kind) {
  if (value == nullptr || value->kind != json::JsonKind::Object) return nullptr;
  const json::Value* const found = value->find(key);
  return found != nullptr && found->kind == kind ? found : nullptr;
}

std::optional<double> numberOf(const json::Value& object, std::string_view key) {
  const json::Value* const number = memberOf(&object, key, json::JsonKind::Number);
  if (number == nullptr || !std::isfinite(number->number)) return std::nullopt;
  return number->number;
}

std::optional<Vec3> threeOf(const json::Value* object, const std::array<const char*, 3>& keys) {
  if (object == nullptr) return std::nullopt;
  Vec3 three;
  for (std::size_t index = 0; index < keys.size(); ++index) {
    const std::optional<double> number = numberOf(*object, keys[index]);
    if (!number) return std::nullopt;
    three[static_cast<Eigen::Index>(index)] = *number;
  }
  return three;
}

std::optional<Mat3> rotationOf(const json::Value* object) {
  const std::optional<Vec3> xyz = threeOf(object, {"x", "y", "z"});
  const std::optional<double> w = xyz ? numberOf(*object, "w") : std::nullopt;
  if (!w) return std::nullopt;
  const Eigen::Quaterniond q(*w, xyz->x(), xyz->y(), xyz->z());
  if (!(std::abs(q.norm() - 1.0) < 0.5)) return std::nullopt;  // a unit quaternion, in a few decimals
  return q.normalized().toRotationMatrix();
}

void takeWord(const json::Value* value, std::string_view key, std::string& word) {
  if (const json::Value* const text = memberOf(value, key, json::JsonKind::String))
    word = text->text.substr(0, kLongestWord);
}

bool isOn(const json::Value* value, std::string_view key, bool otherwise) {
  const json::Value* const flag = memberOf(value, key, json::JsonKind::Bool);
  return flag != nullptr ? flag->boolean : otherwise;
}

std::string idOf(const json::Value& device) {
  std::string id;
  takeWord(&device, "device_id", id);
  return id;
}

void takeConfig(const json::Value* config, Told& told) {
  if (config == nullptr) return;
  takeWord(config, "type", told.type);
  takeWord(config, "extended_firmware_version", told.firmware);
  for (const char* const name : {"coordinate_system", "basis"})  // v3.1, v3.5
    takeWord(memberOf(config, name, json::JsonKind::Object), "permutation", told.axes);
  std::string origin;
  takeWord(config, "coordinate_origin", origin);
  if (!origin.empty()) told.is_middle_origin = origin == "workspace_center";
}

/// Of the first grip that tells one: those with a cable have one button, the others a, b and c.
void takeGrip(const json::Value& root, Told& told) {
  for (const char* const kind : {"custom_verse_grip", "wireless_verse_grip", "verse_grip"}) {
    const json::Value* const grips = memberOf(&root, kind, json::JsonKind::Array);
    if (grips == nullptr || grips->items.empty()) continue;
    const json::Value* const state = memberOf(&grips->items.front(), "state", json::JsonKind::Object);
    if (const std::optional<Mat3> R_HT = rotationOf(memberOf(state, "orientation", json::JsonKind::Object)))
      told.R_HT = R_HT;
    const json::Value* const buttons = memberOf(state, "buttons", json::JsonKind::Object);
    if (buttons == nullptr && memberOf(state, "button", json::JsonKind::Bool) == nullptr) return;
    told.buttons = isOn(state, "button", false) ? 1U : 0U;
    const std::array<const char*, 3> names{"a", "b", "c"};
    for (std::size_t bit = 0; bit < names.size(); ++bit)
      if (isOn(buttons, names[bit], false)) told.buttons |= 1U << bit;
    return;
  }
}

const json::Value* findArm(const json::Value& arms, Told& told) {
  told.ids.clear();
  const json::Value* found = nullptr;
  for (const json::Value& device : arms.items) {
    const std::string id = idOf(device);
    if (id.empty()) continue;
    told.ids.push_back(id);
    if (found == nullptr && (told.id.empty() || told.id == id)) found = &device;
  }
  if (found != nullptr) told.id = idOf(*found);
  return found;
}

}  // namespace

Heard hearMessage(std::string_view text, Told& told) {
  const Result<json::Value> root = json::parse(text, {});
  if (!root || root.value().kind != json::JsonKind::Object) return Heard::Wrong;
  const json::Value* const arms = root.value().find("inverse3");
  if (arms == nullptr) return Heard::Nothing;
  if (arms->kind != json::JsonKind::Array) return Heard::Wrong;
  Told now = told;
  const json::Value* const device = findArm(*arms, now);
  if (device == nullptr) {
    told.ids = now.ids;
    return Heard::Missing;
  }
  const json::Value* const state = memberOf(device, "state", json::JsonKind::Object);
  const std::optional<Vec3> p_HT = threeOf(memberOf(state, "cursor_position", json::JsonKind::Object), {"x", "y", "z"});
  if (!p_HT || !(p_HT->norm() < kFarthest_m)) return Heard::Wrong;
  now.p_HT = *p_HT;
  const std::optional<Vec3> angles_deg =
      threeOf(memberOf(state, "angular_position", json::JsonKind::Object), {"a0", "a1", "a2"});
  if (angles_deg) now.angles_deg = angles_deg;
  takeConfig(memberOf(device, "config", json::JsonKind::Object), now);
  const json::Value* const status = memberOf(device, "status", json::JsonKind::Object);
  now.is_calibrated = isOn(status, "calibrated", now.is_calibrated);
  now.has_power = isOn(status, "power_supply", now.has_power);
  now.is_ready = isOn(status, "ready", now.is_ready);
  takeGrip(root.value(), now);
  told = std::move(now);
  return Heard::Place;
}

Form formOf(std::string_view version_answer) {
  const Result<json::Value> root = json::parse(version_answer, {});
  std::string version;
  if (root) takeWord(&root.value(), "project_version", version);
  int major = 0, minor = 0;
  const char* const end = version.data() + version.size();
  const auto first = std::from_chars(version.data(), end, major);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == '.') std::from_chars(first.ptr + 1, end, minor);
  return major > 3 || (major == 3 && minor >= 5) ? Form::Vector : Form::Values;
}

std::string greetingText(Form form) {
  json::ObjectText session, text;
  if (form == Form::Vector) {
    json::ObjectText profile, configure;
    profile.addText("name", "underact");
    configure.addObject("profile", profile);
    session.addObject("configure", configure);
  }
  session.addObject("force_render_full_state", {});
  text.addObject("session", session);
  return text.text();
}

std::string forceText(std::string_view id, Form form, const Vec3& f_H) {
  json::ObjectText vector, force, commands, device, text;
  vector.addNumber("x", f_H.x());
  vector.addNumber("y", f_H.y());
  vector.addNumber("z", f_H.z());
  force.addObject(form == Form::Vector ? "vector" : "values", vector);
  commands.addObject("set_cursor_force", force);
  device.addText("device_id", id);
  device.addObject("commands", commands);
  text.addObject("session", {});  // their own clients' frames have it
  text.addList("inverse3", std::vector<json::ObjectText>{device});
  return text.text();
}

}  // namespace underact::device::haply
