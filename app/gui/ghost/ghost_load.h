#pragma once
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/base/task_monitor.h"
#include "core/ghost/trajectory.h"
#include "core/scene/description.h"

namespace underact::gui {

/// A session to follow.
struct LoadedGhost {
  std::string name;  // of the session, or its file
  std::string path;
  ghost::Trajectory trajectory;
  arm::MirrorPlane mirror;                  // of its arm
  std::optional<scene::Description> scene;  // of the recording: the first one; none: no scene could be read
  Problems damage;                          // what could not be read of the file
};

/// Reads a whole session, in any thread. Problems: as device::loadRecorded(); an unknown arm; fewer than two ticks.
Result<LoadedGhost> loadGhost(const std::string& path, const TaskMonitor& monitor);

/// Whether both have the same geometry for the hand; the control may differ.
bool hasSameConstraints(const scene::Description& recorded, scene::Description other);

}  // namespace underact::gui
