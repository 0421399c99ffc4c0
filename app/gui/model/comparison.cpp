#include "app/gui/model/comparison.h"

#include <cmath>

namespace underact::gui {

void Comparison::add(const device::RecordedRow& recorded, const servo::TickRecord& now) {
  if (!recorded.is_full || now.level < 1.0 || now.fault != FaultKind::None) return;
  if (!std::isfinite(recorded.error_m) || !std::isfinite(now.error_m)) return;
  recorded_.add(static_cast<double>(recorded.error_m), static_cast<double>(recorded.force_N));
  now_.add(now.error_m, now.f_sent_T_W.norm());
}

}  // namespace underact::gui
