#include "app/gui/replay/session_load.h"

#include <chrono>

namespace underact::gui {

SessionLoad::SessionLoad(const QString& path)
    : path_(path), result_(std::async(std::launch::async, [this]() -> Result<LoadedSession> {
        const std::string file = path_.toStdString();
        const Result<record::Session> session = record::Session::open(file);
        if (!session) return session.problems();
        const auto rate_hz = static_cast<double>(session.value().info().header.rate_hz);
        auto data = std::make_shared<SessionData>();
        device::LoadWatch watch;
        watch.progress = [this](double share) { share_ = share; };
        watch.row = [&](std::int64_t row, const servo::TickRecord& record) { data->add(row, rate_hz, record); };
        watch.cancelled = &cancelled_;
        Result<std::shared_ptr<const device::Recorded>> recorded = device::loadRecorded(file, watch);
        if (!recorded) return recorded.problems();
        data->finish(rate_hz);
        return LoadedSession{std::move(recorded).value(), std::move(data)};
      })) {}

SessionLoad::~SessionLoad() {
  cancel();
  if (result_.valid()) result_.wait();
}

std::optional<Result<LoadedSession>> SessionLoad::take() {
  if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
  return result_.get();
}

}  // namespace underact::gui
