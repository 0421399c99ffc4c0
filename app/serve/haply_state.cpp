#include "app/serve/haply_state.h"

#include <underact/version.h>

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/arm/forward.h"
#include "core/arm/haply_frame.h"
#include "core/base/units.h"
#include "core/json/json.h"

namespace underact::serve::haply {
namespace {

constexpr double kMostForce_N = 1e6;

json::ObjectText vectorText(const Vec3& v) {
  json::ObjectText text;
  text.addNumber("x", v.x());
  text.addNumber("y", v.y());
  text.addNumber("z", v.z());
  return text;
}

json::ObjectText quaternionText(const Mat3& R) {
  const Eigen::Quaterniond q(R);
  json::ObjectText text;
  text.addNumber("w", q.w());
  text.addNumber("x", q.x());
  text.addNumber("y", q.y());
  text.addNumber("z", q.z());
  return text;
}

json::ObjectText transformText(const Vec3& p, const Mat3& R) {
  json::ObjectText text;
  text.addObject("position", vectorText(p));
  text.addObject("rotation", quaternionText(R));
  text.addObject("scale", vectorText(Vec3::Ones()));
  return text;
}

json::ObjectText anglesText(const arm::JointAngles& q_rad) {
  json::ObjectText text;
  text.addNumber("a0", q_rad[0] / kRadPerDegree);
  text.addNumber("a1", q_rad[1] / kRadPerDegree);
  text.addNumber("a2", q_rad[2] / kRadPerDegree);
  return text;
}

json::ObjectText flagText(const char* key, bool on) {
  json::ObjectText text;
  text.addBool(key, on);
  return text;
}

json::ObjectText basisText() {
  json::ObjectText text;
  text.addText("permutation", "XYZ");
  return text;
}

json::ObjectText inverse3Config() {
  json::ObjectText info;
  info.addText("id", kInverse3);
  info.addInteger("major_version", 1);
  info.addInteger("minor_version", 0);
  info.addText("device_type", "inverse3");
  info.addText("uuid", kInverse3);
  json::ObjectText gravity = flagText("enabled", false);
  gravity.addNumber("scaling_factor", 0.0);
  json::ObjectText text;
  text.addText("id", kInverse3);
  text.addText("type", "inverse3");
  text.addObject("device_info", info);
  text.addText("port", "underact");
  text.addText("extended_device_id", kInverse3);
  text.addText("extended_firmware_version", kVersion);
  text.addObject("gravity_compensation", gravity);
  text.addText("handedness", "right");
  text.addObject("torque_scaling", flagText("enabled", false));
  text.addText("coordinate_origin", "device_base");
  text.addObject("basis", basisText());
  text.addText("preset", "defaults");
  text.addObject("mount", transformText(Vec3::Zero(), Mat3::Identity()));
  text.addObject("home_return", flagText("enabled", false));
  return text;
}

json::ObjectText gripConfig() {
  json::ObjectText text;
  text.addText("id", kGrip);
  text.addText("port", "underact");
  text.addText("type", "wireless_verse_grip");
  text.addInteger("major_version", 1);
  text.addInteger("minor_version", 0);
  text.addInteger("hardware_version", 1);
  text.addObject("basis", basisText());
  return text;
}

json::ObjectText inverse3Text(const servo::TickRecord& tick, bool is_full) {
  const bool pushes = tick.mode == servo::Mode::Running;
  json::ObjectText state;
  state.addObject("cursor_position", vectorText(placeOf(tick.p_WT)));
  state.addObject("cursor_velocity", vectorText(vectorOf(tick.v_WT)));
  state.addObject("angular_position", anglesText(tick.q_rad));
  state.addObject("body_orientation", quaternionText(Mat3::Identity()));
  state.addObject("current_cursor_force", vectorText(vectorOf(tick.f_sent_T_W)));
  state.addText("mode", "idle");
  state.addText("control_domain", pushes ? "cartesian" : "undefined");
  state.addText("control_mode", pushes ? "force" : "idle");
  state.addObject("transform", transformText(placeOf(tick.p_WT), Mat3::Identity()));
  json::ObjectText status;
  status.addBool("calibrated", true);
  status.addBool("in_use", pushes);
  status.addBool("power_supply", true);
  status.addBool("ready", tick.mode != servo::Mode::Faulted);
  status.addBool("started", pushes);
  json::ObjectText text;
  text.addText("device_id", kInverse3);
  if (is_full) text.addObject("config", inverse3Config());
  text.addObject("state", state);
  text.addObject("status", status);
  return text;
}

json::ObjectText gripText(const servo::TickRecord& tick, const arm::Geometry& geometry, bool is_full) {
  const Mat3 R_HT = arm::haplyFromWorkspace() * arm::tipPose(geometry, tick.q_rad).linear();
  json::ObjectText buttons;
  const std::array<const char*, 3> names{"a", "b", "c"};
  for (std::size_t bit = 0; bit < names.size(); ++bit) buttons.addBool(names[bit], (tick.buttons >> bit & 1U) != 0U);
  json::ObjectText state;
  state.addNumber("battery_level", 1.0);
  state.addObject("buttons", buttons);
  state.addInteger("hall", 0);
  state.addObject("orientation", quaternionText(R_HT));
  state.addObject("transform", transformText(placeOf(tick.p_WT), R_HT));
  json::ObjectText status;
  status.addBool("ready", true);
  status.addBool("connected", true);
  status.addBool("awake", true);
  json::ObjectText text;
  text.addText("device_id", kGrip);
  if (is_full) text.addObject("config", gripConfig());
  text.addObject("state", state);
  text.addObject("status", status);
  return text;
}

/// Three finite numbers x, y and z.
std::optional<Vec3> vectorIn(const json::Value* value) {
  if (value == nullptr || value->kind != json::Kind::Object) return std::nullopt;
  Vec3 v;
  Eigen::Index axis = 0;
  for (const char* const key : {"x", "y", "z"}) {
    const json::Value* const number = value->find(key);
    if (number == nullptr || number->kind != json::Kind::Number || !(std::abs(number->number) <= kMostForce_N))
      return std::nullopt;
    v[axis++] = number->number;
  }
  return v;
}

const json::Value* objectIn(const json::Value* value, const char* key) {
  if (value == nullptr || value->kind != json::Kind::Object) return nullptr;
  const json::Value* const found = value->find(key);
  return found != nullptr && found->kind == json::Kind::Object ? found : nullptr;
}

/// The force of one device's commands. Problems: it is none.
Problems readForce(const json::Value& device, Frame& frame) {
  const json::Value* const force = objectIn(objectIn(&device, "commands"), "set_cursor_force");
  if (force == nullptr) return {};
  const json::Value* const execute = force->find("execute");
  if (execute != nullptr && execute->kind == json::Kind::Bool && !execute->boolean) return {};
  const json::Value* const vector = force->find("vector");  // v3.5; v3.1 has "values"
  const std::optional<Vec3> f_H = vectorIn(vector != nullptr ? vector : force->find("values"));
  if (!f_H) return Problems{{"set_cursor_force needs a vector of three finite numbers x, y and z."}};
  frame.f_H = *f_H;
  return {};
}

}  // namespace

Vec3 placeOf(const Vec3& p_W) {
  return arm::haplyPlaceFromWorkspace(p_W);
}

Vec3 vectorOf(const Vec3& v_W) {
  return arm::haplyFromWorkspace() * v_W;
}

Vec3 forceOf(const Vec3& f_H) {
  return arm::haplyFromWorkspace().transpose() * f_H;
}

json::ObjectText sessionText(const SessionWords& session) {
  json::ObjectText profile;
  profile.addText("name", session.profile);
  json::ObjectText config;
  config.addObject("profile", profile);
  config.addText("profile_name", session.profile);
  json::ObjectText text;
  text.addInteger("session_id", session.number);
  text.addObject("config", config);
  return text;
}

json::ObjectText versionText() {
  json::ObjectText text;
  for (const char* const key : {"build_time", "git_branch", "git_describe", "git_hash", "git_tag"})
    text.addText(key, "");
  text.addText("project_name", std::string("underact ") + kVersion);
  text.addText("project_version", "3.5.0");  // of the protocol: clients ask for ">=3.5"
  return text;
}

json::ObjectText stateText(const servo::TickRecord& tick, const arm::Geometry& geometry, const SessionWords& session,
                           bool is_full) {
  json::ObjectText text;
  text.addInteger("session_id", session.number);
  if (is_full) text.addObject("session", sessionText(session));
  text.addList("inverse3", std::vector<json::ObjectText>{inverse3Text(tick, is_full)});
  text.addList("verse_grip", std::vector<json::ObjectText>{});
  text.addList("wireless_verse_grip", std::vector<json::ObjectText>{gripText(tick, geometry, is_full)});
  text.addList("custom_verse_grip", std::vector<json::ObjectText>{});
  return text;
}

Result<Frame> readFrame(std::string_view text) {
  const Result<json::Value> root = json::parse(text, {});
  if (!root) return root.problems();
  Frame frame;
  const json::Value* const session = objectIn(&root.value(), "session");
  if (session != nullptr) frame.wants_all = session->find("force_render_full_state") != nullptr;
  const json::Value* const profile = objectIn(objectIn(session, "configure"), "profile");
  if (const json::Value* const name = profile != nullptr ? profile->find("name") : nullptr;
      name != nullptr && name->kind == json::Kind::String)
    frame.profile = name->text;
  const json::Value* const devices = root.value().kind == json::Kind::Object ? root.value().find("inverse3") : nullptr;
  if (devices == nullptr || devices->kind != json::Kind::Array) return frame;
  for (const json::Value& device : devices->items) {
    if (Problems problems = readForce(device, frame); !problems.empty()) return problems;
  }
  return frame;
}

}  // namespace underact::serve::haply
