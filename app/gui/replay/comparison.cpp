#include "app/gui/replay/comparison.h"

#include <algorithm>
#include <cmath>

namespace underact::gui {

void Comparison::Sums::add(double error_m, double sent_N) {
  error_m2 += error_m * error_m;
  force_N += sent_N;
  peak_N = std::max(peak_N, sent_N);
}

void Comparison::add(const device::RecordedRow& recorded, const servo::TickRecord& now) {
  if (!recorded.is_full || now.level < 1.0 || now.fault != FaultKind::None) return;
  if (!std::isfinite(recorded.error_m) || !std::isfinite(now.error_m)) return;
  ++ticks_;
  recorded_.add(static_cast<double>(recorded.error_m), static_cast<double>(recorded.force_N));
  now_.add(now.error_m, now.f_sent_T_W.norm());
}

Figures Comparison::figuresOf(const Sums& sums) const {
  if (ticks_ == 0) return {kNotANumber, kNotANumber, kNotANumber};
  const auto ticks = static_cast<double>(ticks_);
  return {std::sqrt(sums.error_m2 / ticks), sums.peak_N, sums.force_N / ticks};
}

}  // namespace underact::gui
