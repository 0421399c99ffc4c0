#include "core/scene/mesh_notes.h"

#include <cmath>
#include <filesystem>

#include "core/arm/solid_place.h"
#include "core/base/nearest_rotation.h"
#include "core/base/translate.h"
#include "core/json/json.h"
#include "core/json/text.h"
#include "core/mesh_file/report.h"
#include "core/mesh_file/union_report.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"

namespace underact::scene {
namespace {

Sentence sizeNote(const Mesh& mesh) {
  const double largest_mm = std::abs(mesh.scale_mm_per_unit) * mesh_file::largestExtent(*mesh.facts);
  const std::string shown = shownNumber(json::numberText(std::round(largest_mm * 1e3) / 1e3));
  if (largest_mm < mesh_file::kSmallest_mm)
    return phrase(
        TRANSLATE_NOOP("problem", "It is %1 mm long, too small to be felt: state a larger scale_mm_per_unit."),
        {shown});
  if (largest_mm > mesh_file::kLargest_mm)
    return phrase(
        TRANSLATE_NOOP("problem", "It is %1 mm long, far beyond the arm's reach: state a smaller scale_mm_per_unit."),
        {shown});
  return {};
}

/// The rotation of a constraint as its file has it; that of a constraint without one is exact.
Mat3 rotationOf(const Shape& shape) {
  if (const auto* const box = std::get_if<Box>(&shape)) return box->R_WB;
  if (const auto* const mesh = std::get_if<Mesh>(&shape)) return mesh->X_WM.topLeftCorner<3, 3>();
  if (const auto* const curve = std::get_if<Curve>(&shape)) return curve->X_WM.topLeftCorner<3, 3>();
  if (const auto* const robot = std::get_if<VirtualManipulator>(&shape)) return robot->X_WV_home.topLeftCorner<3, 3>();
  return Mat3::Identity();
}

}  // namespace

Problems meshNotes(const Description& scene) {
  Problems notes;
  const auto note_name = [&](const std::string& name, const SourceLocation& place) {
    const std::string path = pathOf(name, scene);
    if (path == std::filesystem::path(scene.file).parent_path() / name) return;
    notes.push_back({phrase(TRANSLATE_NOOP("problem", "There is no file %1, so %2 was read."),
                            {json::shown(name), json::shown(path)}),
                     place});
  };
  if (isArmFile(scene.arm) && scene.arm_text.empty()) note_name(scene.arm, {scene.file, 1, 1, "arm"});
  for (const Constraint& constraint : scene.constraints) {
    if (Sentence note = rotationNote(rotationOf(constraint.shape)); !note.empty())
      notes.push_back({std::move(note), constraint.place});
    const auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    const auto* const curve = std::get_if<Curve>(&constraint.shape);
    if (mesh != nullptr || curve != nullptr) note_name(mesh != nullptr ? mesh->file : curve->file, constraint.place);
    if (curve != nullptr && !curve->note.empty()) notes.push_back({curve->note, constraint.place});
    if (mesh == nullptr || mesh->facts == nullptr) continue;
    const double mm_per_unit = std::abs(mesh->scale_mm_per_unit);
    const Sentence crosses = mesh_file::crossingReport(*mesh->facts);
    const Sentence parts = crosses.empty() ? Sentence() : mesh_file::partsReport(*mesh->facts);
    const Sentence note = oneAfterAnother({parts, crosses, mesh_file::holesReport(*mesh->facts, mm_per_unit),
                                           mesh_file::precisionReport(*mesh->facts, mm_per_unit), sizeNote(*mesh)});
    if (note.empty()) continue;
    notes.push_back(
        {phrase(TRANSLATE_NOOP("problem", "The mesh %1: %2"), {json::shown(mesh->file), note}), constraint.place});
  }
  const Problems of_arm = arm::solidProblems(modelOf(scene));
  notes.insert(notes.end(), of_arm.begin(), of_arm.end());
  return notes;
}

}  // namespace underact::scene
