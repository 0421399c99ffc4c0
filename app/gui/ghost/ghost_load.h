#pragma once
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/base/watch.h"
#include "core/follow/way.h"
#include "core/scene/description.h"

namespace underact::gui {

/// A session as something to follow.
struct LoadedGhost {
  std::string name;  // of the session, or its file
  std::string path;
  follow::Way way;
  std::optional<scene::Description> scene;  // in which it was recorded: the first; none: no scene could be read
  Problems damage;                          // what of the file could not be read
};

/// Reads a session whole, in any thread. Problems: as device::loadRecorded(); an arm that is not known; one tick.
Result<LoadedGhost> loadGhost(const std::string& path, const Watch& watch);

/// Whether a hand meets the same in both; how hard it is pulled may differ.
bool meetsTheSame(const scene::Description& recorded, scene::Description other);

}  // namespace underact::gui
