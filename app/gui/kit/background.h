#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>

namespace underact::gui {

/// What work in another thread and the window say to each other.
struct WorkState {
  std::atomic<bool> cancelled{false};
  std::atomic<double> share{0.0};  // that is done, 0 to 1
};

/// Work in a thread of its own, so that the window goes on. The work looks at state.cancelled now and then.
template <class Outcome>
class Background {
 public:
  explicit Background(std::function<Outcome(WorkState& state)> work)
      : outcome_(std::async(std::launch::async, [this, work = std::move(work)] { return work(state_); })) {}
  ~Background() {  // ends it early
    cancel();
    if (outcome_.valid()) outcome_.wait();
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  void cancel() { state_.cancelled = true; }
  bool isCancelled() const { return state_.cancelled; }
  double share() const { return state_.share; }
  /// What came of it, once; empty while it goes on, and ever after.
  std::optional<Outcome> take() {
    if (!outcome_.valid() || outcome_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    return outcome_.get();
  }

 private:
  WorkState state_;
  std::future<Outcome> outcome_;
};

}  // namespace underact::gui
