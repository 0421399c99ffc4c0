#pragma once
#include <QUndoStack>
#include <functional>
#include <type_traits>
#include <utility>

namespace underact::gui {

/// A change of a state, already in effect when pushed. Changes with the same gesture, such as the drag of a slider, are
/// merged into one; -1: never. A change that ends where it began is dropped.
template <class State>
class Edit : public QUndoCommand {
 public:
  using Put = std::function<void(const State&)>;
  Edit(State before, State after, Put put, const QString& what = {}, int gesture = -1)
      : QUndoCommand(what),
        before_(std::move(before)),
        after_(std::move(after)),
        put_(std::move(put)),
        gesture_(gesture) {}
  int id() const override { return gesture_; }
  void undo() override { put_(before_); }
  void redo() override {
    if (std::exchange(done_, true)) put_(after_);
  }
  bool mergeWith(const QUndoCommand* other) override {
    after_ = static_cast<const Edit*>(other)->after_;
    if constexpr (requires { before_ == after_; })
      setObsolete(before_ == after_);
    else if constexpr (requires { isSame(before_, after_); })
      setObsolete(isSame(before_, after_));
    return true;
  }

 private:
  State before_, after_;
  Put put_;
  int gesture_;
  bool done_ = false;
};

/// A state whose last 200 changes can be undone, starting from the first state set.
template <class State>
class Undoable {
 public:
  Undoable() { stack_.setUndoLimit(200); }
  const State& now() const { return now_; }
  void take(State next) {
    State before = std::exchange(now_, std::move(next));
    if (std::exchange(has_begun_, true))
      stack_.push(new Edit<State>(std::move(before), now_, [this](const State& state) { now_ = state; }));
  }
  QUndoStack& stack() { return stack_; }

 private:
  State now_;
  bool has_begun_ = false;
  QUndoStack stack_;
};

}  // namespace underact::gui
