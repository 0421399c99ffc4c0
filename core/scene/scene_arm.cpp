#include "core/scene/scene_arm.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/arm/mechanism.h"
#include "core/arm/solid_place.h"
#include "core/base/translate.h"
#include "core/json/text.h"
#include "core/scene/load_meshes.h"
#include "core/scene/mesh_names.h"

namespace underact::scene {
namespace {

/// A problem of the scene, not of the file that it names.
Problems ofScene(const Description& scene, Sentence sentence) {
  return {{std::move(sentence), {scene.file, 0, 0, "arm"}}};
}

Result<std::string> textOfArm(const Description& scene, const std::string& path, NamedFiles files) {
  if (!scene.arm_text.empty()) return scene.arm_text;
  if (files == NamedFiles::Closed)
    return ofScene(scene, phrase(TRANSLATE_NOOP("problem",
                                                "The arm %1 is from a file, and the recording does not say what that "
                                                "file contained."),
                                 {json::shown(scene.arm)}));
  Result<std::string> text = json::readTextFile(path, phrase(TRANSLATE_NOOP("problem", "an arm")), kLargestArmFile);
  if (text) return text;
  const Problems problems = withNearest(text.problems(), scene.arm, scene);
  return ofScene(scene, phrase(TRANSLATE_NOOP("problem", "The arm %1: %2"), {path, problems.front().sentence}));
}

}  // namespace

bool isArmFile(std::string_view arm) {
  return arm.find_first_of("./\\") != std::string_view::npos;
}

Problems readSceneArm(Description& scene, NamedFiles files) {
  scene.arm_file.reset();
  if (!isArmFile(scene.arm)) {
    if (scene.arm_text.empty()) return {};
    return ofScene(
        scene,
        phrase(TRANSLATE_NOOP("problem", "\"arm_text\" is the content of an arm file, but \"arm\" names none."), {}));
  }
  const std::string path = scene.arm_text.empty() ? pathOf(scene.arm, scene) : scene.arm;
  Result<std::string> text = textOfArm(scene, path, files);
  if (!text) return text.problems();
  Result<arm::Model> model = arm::readArmText(text.value(), path);
  if (!model) return model.problems();
  if (scene.arm_text.empty()) model = arm::withFolderOf(path, std::move(model));
  Result<arm::Preset> preset = arm::presetOf(model.value());
  if (!preset) return {{preset.problems().front().sentence, {path, 1, 1, "device"}}};
  scene.arm_file = std::make_shared<const ArmFile>(
      ArmFile{std::move(text).value(), std::move(model).value(), std::move(preset).value()});
  return {};
}

const arm::Preset* findArm(const Description& scene) {
  if (!isArmFile(scene.arm)) return arm::findPreset(scene.arm);
  return scene.arm_file != nullptr ? &scene.arm_file->preset : nullptr;
}

const arm::Preset& armOf(const Description& scene) {
  const arm::Preset* const found = findArm(scene);
  return found != nullptr ? *found : *arm::findPreset(arm::kDefaultArm);
}

const arm::Model& modelOf(const Description& scene) {
  if (isArmFile(scene.arm) && scene.arm_file != nullptr) return scene.arm_file->model;
  const arm::Model* const found = arm::findModel(scene.arm);
  return found != nullptr ? *found : *arm::findModel(arm::kDefaultArm);
}

std::optional<bool> rendersMoment(const Description& scene) {
  const bool asks = std::any_of(scene.constraints.begin(), scene.constraints.end(), [](const Constraint& constraint) {
    const auto* const robot = std::get_if<VirtualManipulator>(&constraint.shape);
    return robot != nullptr && robot->orientation != manipulator::Orientation::None;
  });
  if (!asks) return {};
  return armOf(scene).geometry.mechanism->renders_moment;
}

std::string_view armTextOf(const Description& scene) {
  if (!isArmFile(scene.arm)) return arm::fileOf(scene.arm);
  return scene.arm_file != nullptr ? std::string_view(scene.arm_file->text) : std::string_view();
}

bool haveSameArm(const Description& a, const Description& b) {
  const std::string_view one = armTextOf(a), other = armTextOf(b);
  return one == other && (!one.empty() || a.arm == b.arm);
}

Description withArmOf(const Description& other, Description scene) {
  scene.arm = other.arm;
  scene.arm_text = other.arm_text;
  scene.arm_file = other.arm_file;
  return scene;
}

}  // namespace underact::scene
