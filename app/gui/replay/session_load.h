#pragma once
#include <QString>
#include <atomic>
#include <future>
#include <memory>
#include <optional>

#include "app/gui/replay/session_data.h"
#include "device/recorded.h"

namespace underact::gui {

/// A session as the window has it: for the replayed arm and for the charts.
struct LoadedSession {
  std::shared_ptr<const device::Recorded> recorded;
  std::shared_ptr<const SessionData> data;
};

/// Reads a session in a thread of its own, so that the window goes on.
class SessionLoad {
 public:
  explicit SessionLoad(const QString& path);
  ~SessionLoad();  // ends it early
  void cancel() { cancelled_ = true; }
  bool isCancelled() const { return cancelled_; }
  double share() const { return share_; }
  const QString& path() const { return path_; }
  /// What came of it, once; empty while it goes on, and ever after.
  std::optional<Result<LoadedSession>> take();

 private:
  QString path_;
  std::atomic<bool> cancelled_{false};
  std::atomic<double> share_{0.0};
  std::future<Result<LoadedSession>> result_;
};

}  // namespace underact::gui
