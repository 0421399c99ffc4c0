#include "core/tick/report.h"

#include <cmath>

namespace underact::tick {

double errorOf(const TickReport& report) noexcept {
  double sum = 0.0;
  for (const ConstraintReport& held : report.held) {
    if (held.acts) sum += (held.p_WP - report.p_WT).squaredNorm();
  }
  return std::sqrt(sum);
}

}  // namespace underact::tick
