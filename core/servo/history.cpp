#include "core/servo/history.h"

namespace underact::servo {

std::vector<TickRecord> History::inOrder() const {
  const auto split = ring_.begin() + static_cast<std::ptrdiff_t>(next_);
  std::vector<TickRecord> records;
  if (full_) records.assign(split, ring_.end());
  records.insert(records.end(), ring_.begin(), split);
  return records;
}

}  // namespace underact::servo
