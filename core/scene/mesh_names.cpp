#include "core/scene/mesh_names.h"

#include <algorithm>
#include <filesystem>

#include "core/scene/load_meshes.h"

namespace underact::scene {
namespace {

namespace fs = std::filesystem;

/// The greatest number of steps up in a relative path. More of them only reflect where on this disk the mesh is.
constexpr std::ptrdiff_t kMostStepsUp = 2;

}  // namespace

Description namedFrom(Description scene, const std::string& file) {
  const Description before = scene;  // pathOf() needs to know where it was read from
  for (Constraint& constraint : scene.constraints) {
    auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    auto* const curve = std::get_if<Curve>(&constraint.shape);
    if (mesh == nullptr && curve == nullptr) continue;
    std::string& name = mesh != nullptr ? mesh->file : curve->file;
    std::error_code error;
    const fs::path whole = fs::absolute(pathOf(name, before), error).lexically_normal();
    if (error) continue;
    const fs::path relative = whole.lexically_relative(fs::path(file).parent_path().lexically_normal());
    const std::ptrdiff_t steps_up = std::count(relative.begin(), relative.end(), fs::path(".."));
    const bool is_near = !relative.empty() && steps_up <= kMostStepsUp;
    name = is_near ? relative.generic_string() : whole.string();
  }
  scene.file = file;
  return scene;
}

}  // namespace underact::scene
