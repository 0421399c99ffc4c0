#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/servo/tap.h"

namespace underact::record {

/// Rows of one kind as a recorder took them, and which of them it has written.
template <class Row>
struct WaitingRows {
  std::vector<Row> rows;
  std::size_t next = 0;
  /// Whether one is left of a tick before that.
  bool isBefore(std::int64_t tick) const { return next < rows.size() && rows[next].tick < tick; }
  /// Writes those of the ticks before one.
  template <class Write>
  void writeBefore(std::int64_t tick, Write&& write) {
    for (; isBefore(tick); ++next) write(rows[next]);
  }
  /// Takes what came since the last time; the others are written.
  void takeFrom(servo::Tap& tap) {
    rows.clear();
    next = 0;
    for (Row row; tap.take(row);) rows.push_back(row);
  }
};

}  // namespace underact::record
