#pragma once
#include <optional>

#include "app/gui/model/servo_facts.h"
#include "core/record/tick_figures.h"
#include "core/scene/description.h"
#include "core/servo/rerun.h"

namespace underact::gui {

/// Another scene that receives the ticks of the one in effect: the same motion, with other gains or another method. Its
/// force is not sent to the arm. It runs in the window's thread, so it may take half of a servo period at most.
class ComparedScene {
 public:
  static constexpr double kMaxOfAPeriod = 0.5;

  /// most_of_a_period: the comparison ends when a tick takes longer than this share of a period, on average.
  explicit ComparedScene(ServoFacts servo, double most_of_a_period = kMaxOfAPeriod)
      : servo_(servo), most_of_a_period_(most_of_a_period) {}
  /// Problems: it is for another arm than the scene in effect, or does not compile; then the previous one is kept.
  Problems setScene(const scene::Description& scene);
  void end() { rerun_.reset(); }
  bool isOn() const { return rerun_.has_value(); }
  const scene::Description& scene() const { return scene_; }  // the last one

  /// Call with every tick of the scene in effect, in order. Problems: the comparison has ended, because a tick takes
  /// too long, or because the scene in effect is now for another arm.
  Problems add(const servo::TickRecord& felt);

  // Only while it is on.
  const servo::Snapshot& snapshot() const { return rerun_->snapshot(); }
  /// Since the last change of either scene; over ticks in which both sent the whole force.
  const record::TickFigures& feltFigures() const { return felt_; }
  const record::TickFigures& figures() const { return beside_; }

 private:
  void clearFigures();

  ServoFacts servo_;
  double most_of_a_period_;
  scene::Description scene_;
  std::optional<servo::Rerun> rerun_;
  bool begins_ = true;
  std::uint64_t revision_ = 0;  // of the scene in effect
  record::TickFigures felt_, beside_;
  std::int64_t ticks_ = 0;
  double spent_s_ = 0.0;  // on ticks_ ticks
};

}  // namespace underact::gui
