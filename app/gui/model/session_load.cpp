#include "app/gui/model/session_load.h"

#include <utility>

#include "app/gui/model/recorded_files.h"

namespace underact::gui {

Result<LoadedSession> loadSession(const std::string& path, const PrepareScene& prepare, WorkState& state) {
  Result<record::Session> session = record::Session::open(path);
  if (!session) return session.problems();
  const auto rate_hz = static_cast<double>(session.value().info().header.rate_hz);
  auto data = std::make_shared<SessionData>();
  device::LoadWatch monitor;
  monitor.progress = [&](double share) { state.share = share; };
  monitor.row = [&](std::int64_t row, const servo::TickRecord& record) { data->add(row, rate_hz, record); };
  monitor.cancelled = &state.cancelled;
  monitor.files_in = recordedFilesFolders();
  Result<std::shared_ptr<const device::Recorded>> recorded = device::loadRecorded(session.value(), monitor);
  if (!recorded) return recorded.problems();
  TaskMonitor pictures;
  pictures.cancelled = &state.cancelled;
  for (const device::RecordedScene& one : recorded.value()->scenes) prepare(one.scene, pictures);
  data->finish(rate_hz);
  return LoadedSession{std::move(recorded).value(), std::move(data)};
}

}  // namespace underact::gui
