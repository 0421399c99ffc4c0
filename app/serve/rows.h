#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/arm/preset.h"
#include "core/base/result.h"
#include "core/json/object_text.h"
#include "core/record/tick_table.h"
#include "core/servo/snapshot.h"

namespace underact::serve {

/// Whether rows are sent as JSON or as packed doubles.
enum class RowFormat : std::uint8_t { Json, Binary };

/// A message, and whether its frame is binary.
struct Message {
  std::string bytes;
  bool is_binary = false;
};

/// What a client wants of each tick, and the rows that it has not got yet.
class Subscription {
 public:
  /// columns: as findColumns() gives them, tick first; stride: every how many ticks.
  Subscription(std::vector<std::size_t> columns, std::int64_t stride, RowFormat format);
  std::int64_t stride() const { return stride_; }
  /// The columns with their units, for the answer.
  std::vector<json::ObjectText> columnTexts() const;
  /// Keeps the row of a tick, by record::numbersOf(); where there is no room, the oldest is dropped.
  void add(std::int64_t tick, const std::vector<double>& numbers);
  /// Ticks that never came here.
  void addMissing(std::int64_t ticks) { dropped_ += ticks / stride_; }
  bool hasDropped() const { return dropped_ > 0; }
  /// Rows that were dropped since the last call.
  std::int64_t takeDropped();
  bool hasRows() const { return !rows_.empty(); }
  /// As many rows as one message takes. Only where there are any.
  Message take();

 private:
  std::string jsonOf(std::size_t rows) const;
  std::string bytesOf(std::size_t rows) const;

  std::vector<std::size_t> columns_;
  std::int64_t stride_;
  RowFormat format_;
  std::size_t width_ = 0;                 // numbers in a row
  std::vector<std::size_t> offsets_;      // of each column's first number in a tick's
  std::deque<std::vector<double>> rows_;  // of columns_ alone
  std::int64_t dropped_ = 0;
};

/// The indices of the columns of these names, tick first. Problems: a name that no column has, with the nearest one; a
/// name twice. Paths below "columns".
Result<std::vector<std::size_t>> findColumns(const std::vector<std::string>& names);

}  // namespace underact::serve
