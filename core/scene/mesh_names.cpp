#include "core/scene/mesh_names.h"

#include <algorithm>
#include <filesystem>

#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"

namespace underact::scene {
namespace {

namespace fs = std::filesystem;

/// The greatest number of steps up in a relative path. More of them only reflect where on this disk the mesh is.
constexpr std::ptrdiff_t kMostStepsUp = 2;

/// The name of what is at path in a scene in that file.
std::string nameFrom(const std::string& path, const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error).lexically_normal();
  if (error) return path;
  const fs::path relative = whole.lexically_relative(fs::path(file).parent_path().lexically_normal());
  const std::ptrdiff_t steps_up = std::count(relative.begin(), relative.end(), fs::path(".."));
  const bool is_near = !relative.empty() && steps_up <= kMostStepsUp;
  return is_near ? relative.generic_string() : whole.string();
}

}  // namespace

Description namedFrom(Description scene, const std::string& file) {
  for (Constraint& constraint : scene.constraints) {
    auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    auto* const curve = std::get_if<Curve>(&constraint.shape);
    if (mesh != nullptr) mesh->file = nameFrom(pathOf(mesh->file, scene), file);
    if (curve != nullptr) curve->file = nameFrom(pathOf(curve->file, scene), file);
  }
  if (isArmFile(scene.arm) && scene.arm_text.empty()) {
    const std::string name = nameFrom(pathOf(scene.arm, scene), file);
    scene.arm = isArmFile(name) ? name : "./" + name;
  }
  scene.file = file;
  return scene;
}

}  // namespace underact::scene
