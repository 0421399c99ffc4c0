#pragma once
#include <functional>
#include <string>

#include "core/scene/manipulators.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {

// Internal to the room: what is particular to meshes and curves.

/// Reads file, checksum, scale_mm_per_unit, X_WM, search and smooth_deg of an object of the file.
void readMesh(ObjectReader& object, Mesh& into);

/// Reads file, scale_mm_per_unit and X_WM, which place the contents of a file in the workspace, and the settings.
template <class FromFile>
void readPlacement(ObjectReader& object, FromFile& into) {
  Findings& findings = object.findings();
  if (const json::Value* file = object.find("file", true)) {
    readText(*file, object.pathOf("file"), into.file, findings);
  } else {
    into.file = "missing";  // reported already
  }
  if (const json::Value* scale = object.find("scale_mm_per_unit")) {
    readNumber(*scale, object.pathOf("scale_mm_per_unit"), into.scale_mm_per_unit, findings);
  }
  if (const json::Value* pose = object.find("X_WM")) readPose(*pose, object.pathOf("X_WM"), into.X_WM, findings);
  readSettings(object, into);
}

/// Called with a key and what is wrong with it.
using Say = std::function<void(const std::string& key, Sentence sentence)>;

/// Checks them; what: "mesh" or "curve", for sentences.
void checkPlacement(const std::string& what, const std::string& file, double scale_mm_per_unit,
                    const Eigen::Matrix4d& X_WM, const Control& control, const Say& say);

/// Reads a curve.
void readCurve(ObjectReader& object, Curve& into);
/// Checks a curve and its guidance.
void checkCurve(const Curve& curve, const Control& control, const Say& say);

/// Checks a mesh: calls say(key within the constraint, sentence) for each number that is not allowed.
void checkMesh(const Mesh& mesh, target::Side side, const Control& control, const Say& say);

/// The mesh in SI. Problems: its file was not loaded; a wall of a mesh that is not closed.
Result<target::MeshPlace> makeMeshPlace(const Mesh& mesh, target::Side side, const SourceLocation& place);

}  // namespace underact::scene
