#pragma once
#include <functional>
#include <string>

#include "core/scene/manipulators.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {

// Inside the room: what is particular to meshes and curves.

/// file, checksum, scale_mm_per_unit, X_WM, search and smooth_deg of an object of the file.
void readMesh(ObjectReader& object, Mesh& into);

/// file, scale_mm_per_unit and X_WM: where what a file holds is in the workspace; and the settings.
template <class FromFile>
void readPlacement(ObjectReader& object, FromFile& into) {
  Findings& findings = object.findings();
  if (const json::Value* file = object.find("file", true)) {
    readText(*file, object.pathOf("file"), into.file, findings);
  } else {
    into.file = "missing";  // said already
  }
  if (const json::Value* scale = object.find("scale_mm_per_unit")) {
    readNumber(*scale, object.pathOf("scale_mm_per_unit"), into.scale_mm_per_unit, findings);
  }
  if (const json::Value* pose = object.find("X_WM")) readPose(*pose, object.pathOf("X_WM"), into.X_WM, findings);
  readSettings(object, into);
}

using Say = std::function<void(const std::string& key, Sentence sentence)>;

/// The same, checked: of what the file holds, "a mesh".
void checkPlacement(const std::string& what, const std::string& file, double scale_mm_per_unit,
                    const Eigen::Matrix4d& X_WM, const Control& control, const Say& say);

/// Those of a curve.
void readCurve(ObjectReader& object, Curve& into);
/// The same for a curve and its guide.
void checkCurve(const Curve& curve, const Control& control, const Say& say);

/// add(key within the constraint, sentence) for each number that no rule allows.
void checkMesh(const Mesh& mesh, target::Side side, const Control& control, const Say& say);

/// What it compiles to, in SI. Problems: its file was not loaded; a wall of a mesh that is not closed.
Result<target::MeshPlace> makeMeshPlace(const Mesh& mesh, target::Side side, const Place& place);

}  // namespace underact::scene
