#pragma once
#include <optional>
#include <vector>

#include "core/registration/fit.h"
#include "core/registration/steady_tip.h"

namespace underact::registration {

/// The reference points are touched one after the other: a press of the stylus's button, or of a key, begins to hold
/// the tip at the point that is due; half a second later it is touched, and the next one is due. One thread.
class Touching {
 public:
  /// What a sample did: a hold began, the tip moved too much (it has to be pressed again), or the point was touched.
  enum class Event { None, Began, Moved, Touched };

  /// points_D: at least one.
  explicit Touching(std::vector<Vec3> points_D);

  /// A sample of the arm, every tick. pressed: its button is down; one that is down at the first sample has no effect
  /// until it was released.
  Event add(std::int64_t time_ns, const Vec3& p_WT, bool pressed);
  /// The key: holds the point that is due from the next sample on.
  void press();
  /// Ends the hold; what was touched stays.
  void release() { still_.end(); }
  /// Makes that point due, whether it was touched or not; after it comes the first untouched one.
  void choose(std::size_t mark);

  const std::vector<Vec3>& points_D() const { return marks_D_; }
  std::size_t due() const { return due_; }  // the number of points: none
  bool isHolding() const { return still_.isRunning(); }
  double share() const { return still_.share(); }  // of the time that it is held
  /// Whether every reference point was touched, and none is due again.
  bool isDone() const;
  /// How it was touched; empty: not yet. mark: below the number of marks, not checked.
  const std::optional<HeldTip>& held(std::size_t mark) const { return held_[mark]; }
  /// The touches so far, in the order of the points.
  std::vector<Touch> touches() const;

 private:
  std::size_t firstUntouched() const;

  std::vector<Vec3> marks_D_;
  std::vector<std::optional<HeldTip>> held_;
  std::size_t due_ = 0;
  SteadyTip still_;
  bool was_pressed_ = true;
};

}  // namespace underact::registration
