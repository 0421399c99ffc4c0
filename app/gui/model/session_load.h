#pragma once
#include <functional>
#include <memory>
#include <string>

#include "app/gui/kit/background.h"
#include "app/gui/model/session_data.h"
#include "core/base/watch.h"
#include "device/recorded.h"

namespace underact::gui {

/// A session as the window has it: for the replayed arm and for the charts.
struct LoadedSession {
  std::shared_ptr<const device::Recorded> recorded;
  std::shared_ptr<const SessionData> data;
};

/// What is made of each scene of a recording in the thread that reads it, so that the view finds it made.
using PrepareScene = std::function<void(const scene::Description& scene, const Watch& watch)>;

/// Reads a session whole, in one pass. Problems: as device::loadRecorded().
Result<LoadedSession> loadSession(const std::string& path, const PrepareScene& prepare, WorkState& state);

}  // namespace underact::gui
