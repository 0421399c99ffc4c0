#include <algorithm>
#include <cmath>

#include "core/arm/file_values.h"
#include "core/arm/joint_reader.h"
#include "core/arm/model.h"
#include "core/arm/solid_file.h"
#include "core/arm/solid_place.h"
#include "core/arm/urdf.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/json/object_reader.h"
#include "core/json/text.h"

namespace underact::arm {
namespace {

using json::Findings;
using json::ObjectReader;
using json::Value;

void readDevice(const Value& value, Model& model, Findings& findings) {
  if (!isKind(value, json::JsonKind::Object, "device", phrase(TRANSLATE_NOOP("problem", "an object in { }")), findings))
    return;
  ObjectReader object(value, "device", phrase(TRANSLATE_NOOP("problem", "a device description")), findings);
  DeviceFigures device;
  device.continuous_force_N = numberAt(object, "continuous_force_N", true, 1.0);
  if (!(device.continuous_force_N > 0.0))
    findings.add(value, "device.continuous_force_N", phrase(TRANSLATE_NOOP("problem", "This must be above 0.")));
  device.continuous_moment_N_m = numberAt(object, "continuous_moment_N_m", false);
  if (!(device.continuous_moment_N_m >= 0.0))
    findings.add(value, "device.continuous_moment_N_m", phrase(TRANSLATE_NOOP("problem", "This must be 0 or above.")));
  // An arm of the thesis's kind is one that is plugged in, and has encoders; another one may be simulated alone.
  const std::size_t joints = model.joints.size();
  const Value* const counts = object.find("encoder_counts_per_turn", omniGeometry(model).has_value());
  const std::string path = "device.encoder_counts_per_turn", number = std::to_string(joints);
  if (counts != nullptr &&
      isKind(*counts, json::JsonKind::Array, path,
             phrase(TRANSLATE_NOOP("problem", "a list of numbers, one for each joint")), findings)) {
    if (counts->items.size() != joints)
      findings.add(
          *counts, path,
          phrase(TRANSLATE_NOOP("problem", "This must be a list of %1 numbers, one for each joint."), {number}));
    for (std::size_t joint = 0; joint < std::min({device.counts_per_turn.size(), joints, counts->items.size()});
         ++joint) {
      const Value& count = counts->items[joint];
      device.counts_per_turn[joint] = count.number;
      if (!(count.kind == json::JsonKind::Number && count.number >= 1.0 && std::isfinite(count.number))) {
        findings.add(count, path + "[" + std::to_string(joint) + "]",
                     phrase(TRANSLATE_NOOP("problem", "This must be a number of at least 1.")));
      }
    }
  }
  object.finish();
  model.device = device;
}

/// A haptic device of the thesis's kind whose file does not say which joints are driven drives its first three, as all
/// of them do.
void undriveGimbal(const Value& root, Model& model) {
  if (!omniGeometry(model)) return;
  const Value* const rows = root.find("dh");
  const bool says = rows != nullptr && std::any_of(rows->items.begin(), rows->items.end(),
                                                   [](const Value& row) { return row.find("driven") != nullptr; });
  for (std::size_t joint = 3; !says && joint < model.joints.size(); ++joint) model.joints[joint].driven = false;
}

Model readWhole(const Value& root, Findings& findings) {
  Model model;
  ObjectReader object(root, "", phrase(TRANSLATE_NOOP("problem", "an arm file")), findings);
  if (numberAt(object, "underact_arm", true, 1.0) != 1.0) {
    findings.add(*object.find("underact_arm"), "underact_arm",
                 phrase(TRANSLATE_NOOP("problem", "This program reads version 1 of arm files.")));
  }
  for (const auto& [key, text] :
       {std::pair{"name", &model.name}, {"title", &model.title}, {"provenance", &model.provenance}}) {
    if (const Value* const value = object.find(key, true)) json::readText(*value, key, *text, findings);
  }
  readJoints(object, model);
  readSolids(object, model);
  if (const Value* const device = object.find("device")) readDevice(*device, model, findings);
  object.finish();
  if (model.device) undriveGimbal(root, model);
  return model;
}

}  // namespace

Result<Model> readArm(std::string_view text, const std::string& file_name) {
  const Result<Value> root = json::parse(text, file_name);
  if (!root) return root.problems();
  Findings findings(file_name);
  if (!isKind(root.value(), json::JsonKind::Object, "",
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"underact_arm\": 1, ...}"}), findings)) {
    return findings.take();
  }
  const Model model = readWhole(root.value(), findings);
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return model;
}

Result<Model> readArmText(std::string_view text, const std::string& file_name, const UrdfEnds& ends) {
  if (isUrdfText(text)) return readUrdf(text, file_name, ends);
  if (!ends.base.empty() || !ends.tip.empty())
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "--base and --tip are for URDF files: other files have one arm.")), {}}};
  return readArm(text, file_name);
}

Result<Model> readArmFile(const std::string& path, const UrdfEnds& ends) {
  const Result<std::string> text = json::readTextFile(path, phrase(TRANSLATE_NOOP("problem", "an arm")), kLargestUrdf);
  if (!text) return text.problems();
  return withFolderOf(path, readArmText(text.value(), path, ends));
}

}  // namespace underact::arm
