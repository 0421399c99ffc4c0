#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>

namespace underact::gui {

/// Shared state of work in another thread and the window.
struct WorkState {
  std::atomic<bool> cancelled{false};
  std::atomic<double> share{0.0};  // that is done, 0 to 1
};

/// Runs work in its own thread, so that the window stays responsive. The work checks state.cancelled now and then.
template <class Outcome>
class Background {
 public:
  explicit Background(std::function<Outcome(WorkState& state)> work)
      : outcome_(std::async(std::launch::async, [this, work = std::move(work)] { return work(state_); })) {}
  ~Background() {  // cancels it
    cancel();
    if (outcome_.valid()) outcome_.wait();
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  void cancel() { state_.cancelled = true; }
  bool isCancelled() const { return state_.cancelled; }
  double share() const { return state_.share; }
  /// The result, once; empty while it is running, and afterwards.
  std::optional<Outcome> take() {
    if (!outcome_.valid() || outcome_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    return outcome_.get();
  }

 private:
  WorkState state_;
  std::future<Outcome> outcome_;
};

}  // namespace underact::gui
