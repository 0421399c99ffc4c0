#pragma once
#include <memory>
#include <string>

#include "app/gui/background.h"
#include "app/gui/replay/session_data.h"
#include "device/recorded.h"

namespace underact::gui {

/// A session as the window has it: for the replayed arm and for the charts.
struct LoadedSession {
  std::shared_ptr<const device::Recorded> recorded;
  std::shared_ptr<const SessionData> data;
};

/// Reads a session whole, in one pass. Problems: as device::loadRecorded().
Result<LoadedSession> loadSession(const std::string& path, WorkState& state);

}  // namespace underact::gui
