#pragma once
#include <functional>
#include <memory>
#include <string>

#include "app/gui/kit/background.h"
#include "app/gui/model/session_data.h"
#include "core/base/task_monitor.h"
#include "device/recorded.h"

namespace underact::gui {

/// A session as the window needs it: for the replayed arm and for the charts.
struct LoadedSession {
  std::shared_ptr<const device::Recorded> recorded;
  std::shared_ptr<const SessionData> data;
};

/// Prepares each scene of a recording for the view, in the thread that reads the recording.
using PrepareScene = std::function<void(const scene::Description& scene, const TaskMonitor& monitor)>;

/// Reads a whole session in one pass. Problems: as for device::loadRecorded().
Result<LoadedSession> loadSession(const std::string& path, const PrepareScene& prepare, WorkState& state);

}  // namespace underact::gui
