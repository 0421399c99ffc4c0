#pragma once
#include <functional>
#include <string>

#include "core/scene/read_parts.h"

namespace underact::scene {

// Inside the room: what is particular to meshes.

inline constexpr double kMostFriction = 5.0;  // rubber on rubber is about 1.2

/// file, checksum, scale_mm_per_unit, X_WM and search of an object of the file.
void readMesh(ObjectReader& object, Mesh& into);

/// add(key within the constraint, sentence) for each number that no rule allows.
void checkMesh(const Mesh& mesh, target::Side side, const Control& control,
               const std::function<void(const std::string&, std::string)>& add);

/// What it compiles to, in SI. Problems: its file was not loaded; a wall of a mesh that is not closed.
Result<target::MeshPlace> makeMeshPlace(const Mesh& mesh, target::Side side, const Place& place);

}  // namespace underact::scene
