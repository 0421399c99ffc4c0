#pragma once
#include <string>

#include "core/arm/model.h"

namespace underact::arm {

// Where the meshes are that an arm is drawn by. A file from somebody else names them, so that a name must not lead out
// of what the person opened: the folder of the arm's file and what is below it, and the package (a folder with a
// package.xml) that this folder is a part of.

/// The path of the file of a mesh of this arm. A name is relative to the folder of the arm's file; package://NAME/...
/// is looked for in that folder, and in its parents where there is such a package, or one whose package.xml has the
/// name. Links are followed before it is judged where a file is. Problems: one, at the mesh's place: there is no such
/// file; it is elsewhere; the arm is of no file on this disk, as in a recording.
Result<std::string> fileOfSolid(const Model& model, const MeshSolid& mesh);

/// The notes of its file, and the problems of all its meshes; of these none where the arm is of no file.
Problems solidProblems(const Model& model);

/// A model that was read from the file at that path.
Result<Model> withFolderOf(const std::string& path, Result<Model> model);

/// Whether a mesh can have these factors, m per unit of its file.
bool isMeshScale(const Vec3& m_per_unit);

}  // namespace underact::arm
