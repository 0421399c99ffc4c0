#pragma once
#include <atomic>
#include <functional>

namespace underact {

/// Progress and cancellation of work that takes seconds.
struct TaskMonitor {
  std::function<void(const char* step, double share)> progress;  // of the whole work, 0 to 1; may be empty
  const std::atomic<bool>* cancelled = nullptr;                  // true: end soon, with a problem that says so
  /// Whether the work is to be cancelled. Any thread.
  bool isCancelled() const { return cancelled != nullptr && *cancelled; }
  /// Reports progress. step: what is being done, untranslated; share: of the whole work, 0 to 1.
  void report(const char* step, double share) const {
    if (progress) progress(step, share);
  }
};

}  // namespace underact
