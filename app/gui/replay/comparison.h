#pragma once
#include <cstdint>

#include "core/servo/snapshot.h"
#include "device/recorded.h"

namespace underact::gui {

/// Error and force of a stretch of ticks.
struct Figures {
  double rms_error_m = 0.0;
  double peak_N = 0.0;
  double mean_N = 0.0;
};

/// The same ticks as they were recorded and as they are now. Only those count in which both times the ramps let the
/// whole force through: a start is no gain.
class Comparison {
 public:
  void clear() { *this = Comparison{}; }
  void add(const device::RecordedRow& recorded, const servo::TickRecord& now);
  std::int64_t ticks() const { return ticks_; }
  Figures recorded() const { return figuresOf(recorded_); }
  Figures now() const { return figuresOf(now_); }

 private:
  struct Sums {
    double error_m2 = 0.0, force_N = 0.0, peak_N = 0.0;
    void add(double error_m, double force_N);
  };
  Figures figuresOf(const Sums& sums) const;

  std::int64_t ticks_ = 0;
  Sums recorded_, now_;
};

}  // namespace underact::gui
