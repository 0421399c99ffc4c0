#pragma once
#include <atomic>
#include <future>
#include <optional>

#include "core/servo/check.h"

namespace underact::gui {

/// A check of the servo in a thread of its own, on a simulated arm of its own, so that window and arm go on.
class CheckRun {
 public:
  explicit CheckRun(const servo::CheckOptions& options);
  ~CheckRun();  // ends it early
  void cancel() { cancelled_ = true; }
  double share() const { return share_; }
  /// What was measured, once; empty while it goes on, and ever after.
  std::optional<servo::CheckResult> takeResult();

 private:
  std::atomic<bool> cancelled_{false};
  std::atomic<double> share_{0.0};
  std::future<servo::CheckResult> result_;
};

}  // namespace underact::gui
