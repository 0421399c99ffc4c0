#pragma once
#include <optional>

#include "core/scene/description.h"

namespace underact::gui::tuned_scenes {

// Scenes that came with the program as a person has tuned them: nobody saves these, so they are kept in the settings.

/// Keeps it as the scene in original's file is to be opened the next time; the same as original: forgets it. Both as in
/// a file.
void keep(const scene::Description& original, const scene::Description& tuned);

/// How it was left, without meshes; none: it was not tuned, or its file has changed since.
std::optional<scene::Description> of(const scene::Description& original);

}  // namespace underact::gui::tuned_scenes
