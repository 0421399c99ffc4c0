#pragma once
#include <atomic>
#include <functional>

namespace underact {

/// How a work of seconds is looked at and ended early.
struct Watch {
  std::function<void(const char* step, double share)> progress;  // of the whole work, 0 to 1; may be empty
  const std::atomic<bool>* cancelled = nullptr;                  // true: give up soon, with a problem that says so
  /// Whether whoever began the work wants it to end. Any thread.
  bool isCancelled() const { return cancelled != nullptr && *cancelled; }
  /// Reports progress. step: what is being done, untranslated; share: of the whole work, 0 to 1.
  void tell(const char* step, double share) const {
    if (progress) progress(step, share);
  }
};

}  // namespace underact
