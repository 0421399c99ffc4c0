#pragma once
#include <utility>
#include <vector>

namespace underact::gui {

/// A state with the ones before it and, after a step back, the ones after it; nothing until the first is taken.
template <class State>
class History {
 public:
  const State& now() const { return states_[at_]; }
  /// From now on this one; what was taken back is forgotten.
  void take(State state) {
    if (!states_.empty()) states_.resize(at_ + 1);
    if (states_.size() == kMost) states_.erase(states_.begin());
    states_.push_back(std::move(state));
    at_ = states_.size() - 1;
  }
  bool canUndo() const { return at_ > 0; }
  bool canRedo() const { return at_ + 1 < states_.size(); }
  bool undo() { return canUndo() && (--at_, true); }
  bool redo() { return canRedo() && (++at_, true); }

 private:
  static constexpr std::size_t kMost = 200;
  std::vector<State> states_;
  std::size_t at_ = 0;
};

}  // namespace underact::gui
