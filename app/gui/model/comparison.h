#pragma once
#include <cstdint>

#include "core/record/tick_figures.h"
#include "core/servo/snapshot.h"
#include "device/recorded.h"

namespace underact::gui {

/// Ticks as recorded and as they are now. Only ticks with the full force in both are counted: a ramp is not a
/// difference between scenes.
class Comparison {
 public:
  void clear() { *this = Comparison{}; }
  void add(const device::RecordedRow& recorded, const servo::TickRecord& now);
  std::int64_t ticks() const { return now_.ticks(); }
  const record::TickFigures& recorded() const { return recorded_; }
  const record::TickFigures& now() const { return now_; }

 private:
  record::TickFigures recorded_, now_;
};

}  // namespace underact::gui
