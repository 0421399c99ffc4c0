#pragma once
#include <optional>
#include <vector>

#include "core/registration/fit.h"
#include "core/registration/still.h"

namespace underact::registration {

/// Mark after mark is touched: a press of the stylus's button, or of a key, begins to hold the tip at the mark that is
/// due; half a second later it is touched, and the next one is due. Of one thread.
class Touching {
 public:
  /// What a sample did: a hold began, the tip moved too much (it has to be pressed again), or the point was touched.
  enum class Event { None, Began, Moved, Touched };

  /// marks_D: at least one.
  explicit Touching(std::vector<Vec3> marks_D);

  /// A sample of the arm, every tick. pressed: its button is down; one that was down from the first sample on begins
  /// nothing until it was let go.
  Event add(std::int64_t time_ns, const Vec3& p_WT, bool pressed);
  /// The key: holds the mark that is due from the next sample on.
  void press();
  /// Nothing is being held any more; what was touched stays.
  void letGo() { still_.end(); }
  /// That mark is due, whether it was touched or not; after it the first that was not.
  void choose(std::size_t mark);

  const std::vector<Vec3>& marks_D() const { return marks_D_; }
  std::size_t due() const { return due_; }  // the number of marks: none
  bool isHolding() const { return still_.isAtWork(); }
  double share() const { return still_.share(); }  // of the time that it is held
  /// Whether every reference point was touched, and none is due again.
  bool isDone() const;
  /// How it was touched; empty: not yet. mark: below the number of marks, not checked.
  const std::optional<Held>& held(std::size_t mark) const { return held_[mark]; }
  /// Of the marks that were touched, in their order.
  std::vector<Touch> touches() const;

 private:
  std::size_t firstUntouched() const;

  std::vector<Vec3> marks_D_;
  std::vector<std::optional<Held>> held_;
  std::size_t due_ = 0;
  Still still_;
  bool was_pressed_ = true;
};

}  // namespace underact::registration
