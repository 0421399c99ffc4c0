#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/scene/description.h"

namespace underact::scene {

// Edits of a scene: each gives a whole scene, so that one way into the servo and one way back serve them all. Of its
// settings: settings.h.

/// The scene with control in place of the one that holds at index. Where the scene's control is that of a single
/// constraint, it is the scene's that is edited. index: of a constraint that is there.
Description withControl(Description scene, std::size_t index, const Control& control);
/// The scene with another shape in place of the one at index.
Description withShape(Description scene, std::size_t index, const Shape& shape);
/// With one more constraint at the end; a number goes behind its name where that is taken.
Description withAdded(Description scene, Constraint constraint);
/// Without the constraint at index.
Description without(Description scene, std::size_t index);

/// Whether both say the same of everything, wherever they were read from and whichever control is whose.
bool isSame(const Description& a, const Description& b);

/// How much a running servo can keep over an edit. Gains: all; the targets are where they were. Targets: what the laws
/// remember of the past, but a target is elsewhere now. Scene: nothing; what one law remembers says nothing to another.
enum class Change : std::uint8_t { Gains, Targets, Scene };
/// What the step from before to after is. Another arm, combination, number or kind of constraints, or space: Scene.
Change changeBetween(const Description& before, const Description& after);

}  // namespace underact::scene
