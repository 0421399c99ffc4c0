#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/scene/description.h"

namespace underact::scene {

// Edits of a scene: each returns a whole scene, so that one path into the servo and one undo serve them all. For
// settings see settings.h.

/// The scene with control in place of the one in effect at index. Where the scene's control serves a single constraint,
/// the scene's is edited. index: of an existing constraint.
Description withControl(Description scene, std::size_t index, const Control& control);
/// The scene with another shape for the constraint at index.
Description withShape(Description scene, std::size_t index, const Shape& shape);
/// With one more constraint at the end; a number is appended to its name where the name is taken.
Description withAdded(Description scene, Constraint constraint);
/// Without the constraint at index.
Description without(Description scene, std::size_t index);

/// Whether both state the same, no matter where they were read from and which control belongs to whom.
bool isSame(const Description& a, const Description& b);

/// How much a running servo can keep across an edit. Gains: everything; the targets have not moved. Targets: the memory
/// of the control laws, but a target has moved. Scene: nothing; the memory of one law is meaningless to another.
enum class Change : std::uint8_t { Gains, Targets, Scene };
Change changeBetween(const Description& before, const Description& after);

}  // namespace underact::scene
