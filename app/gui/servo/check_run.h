#pragma once
#include <atomic>
#include <future>
#include <optional>

#include "core/servo/check.h"

namespace underact::gui {

/// A check of the servo in its own thread, on its own simulated arm, so that the window and the arm in use keep
/// running.
class CheckRun {
 public:
  explicit CheckRun(const servo::CheckOptions& options);
  ~CheckRun();  // ends it early
  void cancel() { cancelled_ = true; }
  double share() const { return share_; }
  /// The result, once; empty while the check runs and after the result was taken.
  std::optional<servo::CheckResult> takeResult();

 private:
  std::atomic<bool> cancelled_{false};
  std::atomic<double> share_{0.0};
  std::future<servo::CheckResult> result_;
};

}  // namespace underact::gui
