#pragma once
#include <optional>

#include "app/gui/model/servo_facts.h"
#include "core/record/tick_figures.h"
#include "core/scene/description.h"
#include "core/servo/rerun.h"

namespace underact::gui {

/// Another scene fed with the ticks of the one in effect: the same motion, with other gains or another method. The arm
/// gets nothing of its force. It reckons in the window's thread, so it has half of each tick's time at most.
class Beside {
 public:
  static constexpr double kMostOfAPeriod = 0.5;

  /// most_of_a_period: a tick's time beyond which, on average, it ends.
  explicit Beside(ServoFacts servo, double most_of_a_period = kMostOfAPeriod)
      : servo_(servo), most_of_a_period_(most_of_a_period) {}
  /// Problems: another arm than that of the scene in effect; it does not compile. Then the one before it stays.
  Problems setScene(const scene::Description& scene);
  void end() { rerun_.reset(); }
  bool isOn() const { return rerun_.has_value(); }
  const scene::Description& scene() const { return scene_; }  // the last one

  /// Every tick of the scene in effect, in order. Problems: it goes on no longer, because it takes too much time, or
  /// because the scene in effect is for another arm now.
  Problems add(const servo::TickRecord& felt);

  // Where it is on.
  const servo::Snapshot& snapshot() const { return rerun_->snapshot(); }
  /// Since either scene was changed last; of ticks in which the ramps of both let the whole force through.
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
  double spent_s_ = 0.0;  // on so many ticks
};

}  // namespace underact::gui
