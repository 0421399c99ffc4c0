#pragma once
#include <cstdint>

#include "core/record/tick_figures.h"
#include "core/servo/snapshot.h"
#include "device/recorded.h"

namespace underact::gui {

/// The same ticks as they were recorded and as they are now. Only those count in which both times the ramps let the
/// whole force through: a start is no gain.
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
