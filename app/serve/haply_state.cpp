#include "app/serve/haply_state.h"

#include <underact/version.h>

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "core/arm/forward.h"
#include "core/arm/haply_frame.h"
#include "core/base/units.h"
#include "core/json/json.h"

namespace underact::serve::haply {
namespace {

constexpr std::size_t kLongestProfile = 100;
constexpr double kMax = 1e6;       // of N, m and what else a client gives
constexpr int kInverse3Model = 4;  // https://docs.haply.co/inverseSDK/service/realtime/websocket-protocol

json::ObjectText vectorText(const Vec3& v) {
  json::ObjectText text;
  text.addNumber("x", v.x());
  text.addNumber("y", v.y());
  text.addNumber("z", v.z());
  return text;
}

json::ObjectText quaternionText(const Eigen::Quaterniond& q) {
  json::ObjectText text;
  text.addNumber("w", q.w());
  text.addNumber("x", q.x());
  text.addNumber("y", q.y());
  text.addNumber("z", q.z());
  return text;
}

json::ObjectText transformText(const Workspace& workspace) {
  json::ObjectText text;
  text.addObject("position", vectorText(workspace.position));
  text.addObject("rotation", quaternionText(workspace.rotation));
  text.addObject("scale", vectorText(workspace.scale));
  return text;
}

json::ObjectText anglesText(const Vec3& a_deg) {
  json::ObjectText text;
  text.addNumber("a0", a_deg[0]);
  text.addNumber("a1", a_deg[1]);
  text.addNumber("a2", a_deg[2]);
  return text;
}

constexpr const char* kBasis = R"({"permutation": "XYZ"})";

json::ObjectText inverse3Config() {
  json::ObjectText info;
  info.addText("id", kInverse3);
  info.addInteger("major_version", 1);
  info.addInteger("minor_version", 0);
  info.addInteger("device_type", kInverse3Model);
  info.addText("uuid", kInverse3);
  json::ObjectText text;
  text.addText("id", kInverse3);
  text.addText("type", "inverse3");
  text.addObject("device_info", info);
  text.addText("port", "underact");
  text.addText("extended_device_id", kInverse3);
  text.addText("extended_firmware_version", kVersion);
  text.addJson("gravity_compensation", R"({"enabled": false, "scaling_factor": 0})");
  text.addText("handedness", "right");
  text.addText("streaming_mode", "USB");
  text.addJson("torque_scaling", R"({"enabled": false})");
  text.addText("coordinate_origin", "device_base");
  text.addJson("basis", kBasis);
  text.addText("preset", "defaults");
  text.addObject("mount", transformText({}));
  text.addJson("home_return", R"({"enabled": false})");
  text.addJson("filters", R"({"force_gate": {"gain": 0}, "damping": {"scalar": 0}})");  // it has none
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
  text.addText("streaming_mode", "Radio");
  text.addJson("basis", kBasis);
  return text;
}

json::ObjectText inverse3Text(const servo::TickRecord& tick, const Vec3& turning, const Workspace& workspace,
                              bool is_full) {
  const bool pushes = tick.mode == servo::Mode::Running;
  json::ObjectText state;
  state.addObject("cursor_position", vectorText(workspace.place(placeOf(tick.p_WT))));
  state.addObject("cursor_velocity", vectorText(workspace.vector(vectorOf(tick.v_WT))));
  state.addObject("angular_position", anglesText(anglesOf(tick)));
  state.addObject("angular_velocity", anglesText(turning));
  state.addObject("body_orientation", quaternionText(Eigen::Quaterniond::Identity()));
  state.addObject("current_cursor_force", vectorText(workspace.rotation * vectorOf(tick.f_sent_T_W)));
  // Those of commands that are passed over.
  state.addObject("current_cursor_position", vectorText(Vec3::Zero()));
  state.addObject("current_angular_torques", anglesText(Vec3::Zero()));
  state.addObject("current_angular_position", anglesText(Vec3::Zero()));
  state.addText("mode", "idle");
  state.addText("control_domain", pushes ? "cartesian" : "undefined");
  state.addText("control_mode", pushes ? "force" : "idle");
  state.addObject("transform", transformText(workspace));
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

json::ObjectText gripText(const servo::TickRecord& tick, const arm::Geometry& geometry, const Workspace& workspace,
                          bool is_full) {
  const Mat3 R_HT = arm::haplyFromWorkspace() * arm::tipPose(geometry, tick.q_rad).linear();
  json::ObjectText buttons;
  const std::array<const char*, 3> names{"a", "b", "c"};
  for (std::size_t bit = 0; bit < names.size(); ++bit) buttons.addBool(names[bit], (tick.buttons >> bit & 1U) != 0U);
  json::ObjectText state;
  state.addNumber("battery_level", 1.0);
  state.addObject("buttons", buttons);
  state.addInteger("hall", 0);
  state.addObject("orientation", quaternionText(workspace.rotation * Eigen::Quaterniond(R_HT)));
  state.addObject("transform", transformText(workspace));
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

/// Finite numbers x, y, z and, of four, w.
template <class Numbers>
std::optional<Numbers> numbersIn(const json::Value* value) {
  if (value == nullptr || value->kind != json::JsonKind::Object) return std::nullopt;
  Numbers numbers;
  for (Eigen::Index at = 0; at < numbers.size(); ++at) {
    const json::Value* const number = value->find(std::string_view("xyzw").substr(static_cast<std::size_t>(at), 1));
    if (number == nullptr || number->kind != json::JsonKind::Number || !(std::abs(number->number) <= kMax))
      return std::nullopt;
    numbers[at] = number->number;
  }
  return numbers;
}

const json::Value* objectIn(const json::Value* value, const char* key) {
  if (value == nullptr || value->kind != json::JsonKind::Object) return nullptr;
  const json::Value* const found = value->find(key);
  return found != nullptr && found->kind == json::JsonKind::Object ? found : nullptr;
}

/// A command of one device that is to be executed.
const json::Value* commandOf(const json::Value& device, const char* name) {
  const json::Value* const command = objectIn(objectIn(&device, "commands"), name);
  const json::Value* const execute = command != nullptr ? command->find("execute") : nullptr;
  return execute != nullptr && execute->kind == json::JsonKind::Bool && !execute->boolean ? nullptr : command;
}

/// The force of one device's commands. Problems: it is none.
Problems readForce(const json::Value& device, Frame& frame) {
  const json::Value* const force = commandOf(device, "set_cursor_force");
  if (force == nullptr) return {};
  const json::Value* const vector = force->find("vector");  // v3.5; v3.1 has "values"
  frame.f_A = numbersIn<Vec3>(vector != nullptr ? vector : force->find("values"));
  if (!frame.f_A) return Problems{{"set_cursor_force needs a vector of three finite numbers x, y and z."}};
  return {};
}

/// The transform of one device's commands; what it leaves out stays. Problems: it is none.
Problems readTransform(const json::Value& device, Workspace& workspace) {
  const json::Value* const given = objectIn(commandOf(device, "set_transform"), "transform");
  if (given == nullptr) return {};
  const auto part = [&]<class Numbers>(const char* key, const Numbers& now) -> std::optional<Numbers> {
    const json::Value* const found = given->find(key);
    return found != nullptr ? numbersIn<Numbers>(found) : now;
  };
  const auto position = part("position", workspace.position), scale = part("scale", workspace.scale);
  const auto rotation = part("rotation", Eigen::Vector4d(workspace.rotation.coeffs()));
  if (!position || !scale || !rotation || rotation->isZero())
    return Problems{{"set_transform needs finite numbers, and a rotation that is one."}};
  workspace = {*position, Eigen::Quaterniond(*rotation).normalized(), *scale};
  return {};
}

}  // namespace

Vec3 placeOf(const Vec3& p_W) {
  return arm::haplyPlaceFromWorkspace(p_W);
}

Vec3 vectorOf(const Vec3& v_W) {
  return arm::haplyFromWorkspace() * v_W;
}

Vec3 forceOf(const Workspace& workspace, const Vec3& f_A) {
  return arm::haplyFromWorkspace().transpose() * (workspace.rotation.conjugate() * f_A);
}

Vec3 anglesOf(const servo::TickRecord& tick) {
  return Vec3(tick.q_rad[0], tick.q_rad[1], tick.q_rad[2]) / kRadPerDegree;
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

json::ObjectText stateText(const servo::TickRecord& tick, const Vec3& turning, const arm::Geometry& geometry,
                           const SessionWords& session, bool is_full) {
  json::ObjectText text;
  text.addInteger("session_id", session.number);
  if (is_full) text.addObject("session", sessionText(session));
  text.addList("inverse3", std::vector<json::ObjectText>{inverse3Text(tick, turning, session.arm, is_full)});
  text.addList("verse_grip", std::vector<json::ObjectText>{});
  text.addList("wireless_verse_grip", std::vector<json::ObjectText>{gripText(tick, geometry, session.grip, is_full)});
  text.addList("custom_verse_grip", std::vector<json::ObjectText>{});
  return text;
}

Result<Frame> readFrame(std::string_view text, const SessionWords& session) {
  const Result<json::Value> root = json::parse(text, {});
  if (!root) return root.problems();
  Frame frame;
  frame.session = session;
  const json::Value* const settings = objectIn(&root.value(), "session");
  if (settings != nullptr) frame.wants_all = settings->find("force_render_full_state") != nullptr;
  const json::Value* const profile = objectIn(objectIn(settings, "configure"), "profile");
  const json::Value* const name = profile != nullptr ? profile->find("name") : nullptr;
  frame.names_profile = name != nullptr && name->kind == json::JsonKind::String;
  if (frame.names_profile) frame.session.profile = name->text.substr(0, kLongestProfile);
  const auto devices = [&](const char* list) -> std::span<const json::Value> {
    const json::Value* const found = root.value().kind == json::JsonKind::Object ? root.value().find(list) : nullptr;
    if (found == nullptr || found->kind != json::JsonKind::Array) return {};
    return found->items;
  };
  Problems problems;
  for (const json::Value& arm : devices("inverse3")) {
    if (problems.empty()) problems = readForce(arm, frame);
    if (problems.empty()) problems = readTransform(arm, frame.session.arm);
  }
  for (const json::Value& grip : devices("wireless_verse_grip"))
    if (problems.empty()) problems = readTransform(grip, frame.session.grip);
  if (!problems.empty()) return problems;
  return frame;
}

}  // namespace underact::serve::haply
