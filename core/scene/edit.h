#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/scene/description.h"

namespace underact::scene {

// Edits of a scene: each gives a whole scene, so that running and undoing need one path for all. Edits of settings:
// settings.h.

/// The scene with control in place of that of the constraint at index. Where the scene's control has a single
/// constraint, the scene's is edited. index: of an existing constraint.
Description withControl(Description scene, std::size_t index, const Control& control);
/// The scene with another shape for the constraint at index.
Description withShape(Description scene, std::size_t index, const Shape& shape);
/// The scene with one more constraint at the end; a number is appended to its name if that is taken.
Description withAdded(Description scene, Constraint constraint);
/// Without the constraint at index.
Description without(Description scene, std::size_t index);

/// Whether both are equal in all values, wherever they were read from and whether a control is the scene's or a
/// constraint's own.
bool isSame(const Description& a, const Description& b);

/// What a running servo keeps over an edit. Gains: all; the targets are unchanged. Targets: the state of the laws,
/// while a target has moved. Scene: nothing; the state of one law means nothing to another.
enum class Change : std::uint8_t { Gains, Targets, Scene };
/// The kind of edit from before to after. Another arm, combination, number or kind of constraints, or space: Scene.
Change changeBetween(const Description& before, const Description& after);

}  // namespace underact::scene
