#include "app/serve/rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "app/serve/request.h"
#include "core/json/text.h"

namespace underact::serve {
namespace {

constexpr std::size_t kMaxRows = 16384;       // kept for a client: 4 s at 4 kHz, with all columns 6 MB
constexpr std::size_t kMaxRowsAtOnce = 1024;  // in a message

std::size_t widthOf(const record::Column& column) {
  return static_cast<std::size_t>(column.width);
}

/// A whole number with all its digits.
std::string cellText(double number, record::NumberKind kind) {
  if (kind == record::NumberKind::Real) return json::numberText(number);
  return std::to_string(static_cast<std::int64_t>(number));
}

/// What is not there, as the target where nothing is touched, is an empty list: null is never a value.
std::string textOfCell(const double* numbers, const record::Column& column) {
  if (!std::all_of(numbers, numbers + column.width, [](double number) { return std::isfinite(number); })) return "[]";
  if (column.width == 1) return cellText(*numbers, column.kind);
  std::string text = "[";
  for (int part = 0; part < column.width; ++part) text += (part > 0 ? ", " : "") + cellText(numbers[part], column.kind);
  return text + "]";
}

void append(std::string& bytes, const void* value, std::size_t count) {
  static_assert(std::endian::native == std::endian::little);
  bytes.append(static_cast<const char*>(value), count);
}

/// Those of a tick, and the joints beyond the sixth, which a session has in a table of their own.
std::span<const record::Column> servedColumns() {
  return record::tickColumns(true);
}

}  // namespace

Subscription::Subscription(std::vector<std::size_t> columns, std::int64_t stride, RowFormat format)
    : columns_(std::move(columns)), stride_(stride), format_(format) {
  for (const std::size_t index : columns_) {
    std::size_t offset = 0;
    for (std::size_t before = 0; before < index; ++before) offset += widthOf(servedColumns()[before]);
    offsets_.push_back(offset);
    width_ += widthOf(servedColumns()[index]);
  }
}

std::vector<json::ObjectText> Subscription::columnTexts() const {
  std::vector<json::ObjectText> texts;
  for (const std::size_t index : columns_) {
    const record::Column& column = servedColumns()[index];
    json::ObjectText text;
    text.addText("name", column.name);
    text.addText("unit", column.unit);
    text.addInteger("width", column.width);
    texts.push_back(text);
  }
  return texts;
}

void Subscription::add(std::int64_t tick, const std::vector<double>& numbers) {
  if (tick % stride_ != 0) return;
  if (rows_.size() >= kMaxRows) {
    rows_.pop_front();
    ++dropped_;
  }
  std::vector<double>& row = rows_.emplace_back();
  row.reserve(width_);
  for (std::size_t at = 0; at < columns_.size(); ++at) {
    const double* const first = numbers.data() + offsets_[at];
    row.insert(row.end(), first, first + servedColumns()[columns_[at]].width);
  }
}

std::int64_t Subscription::takeDropped() {
  return std::exchange(dropped_, 0);
}

Message Subscription::take() {
  const std::size_t rows = std::min(rows_.size(), kMaxRowsAtOnce);
  const bool is_binary = format_ == RowFormat::Binary;
  Message message{is_binary ? bytesOf(rows) : jsonOf(rows), is_binary};
  rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(rows));
  return message;
}

std::string Subscription::bytesOf(std::size_t rows) const {
  std::string bytes;
  bytes.reserve(8 + rows * width_ * sizeof(double));
  const std::uint64_t count = rows;
  append(bytes, &count, sizeof count);
  for (std::size_t row = 0; row < rows; ++row) append(bytes, rows_[row].data(), width_ * sizeof(double));
  return bytes;
}

std::string Subscription::jsonOf(std::size_t rows) const {
  std::string text = "{\"ticks\": {";
  std::size_t offset = 0;
  for (std::size_t at = 0; at < columns_.size(); ++at) {
    const record::Column& column = servedColumns()[columns_[at]];
    text += (at > 0 ? ", " : "") + json::quotedText(column.name) + ": [";
    for (std::size_t row = 0; row < rows; ++row)
      text += (row > 0 ? ", " : "") + textOfCell(rows_[row].data() + offset, column);
    text += "]";
    offset += widthOf(column);
  }
  return text + "}}";
}

Result<std::vector<std::size_t>> findColumns(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const record::Column& column : servedColumns()) known.emplace_back(column.name);
  std::vector<std::size_t> found{0};  // tick, which names the rows
  Problems problems;
  for (std::size_t at = 0; at < names.size(); ++at) {
    const auto column = std::find(known.begin(), known.end(), names[at]);
    const auto index = static_cast<std::size_t>(column - known.begin());
    const std::string path = "/columns/" + std::to_string(at);
    if (problems.size() >= kMaxProblems) break;
    if (column == known.end()) {
      const std::string nearest = problems.size() < kMaxHints ? json::nearestWord(names[at], known) : "";
      problems.push_back({"A session has no column " + json::shown(names[at]) +
                              (nearest.empty() ? ". \"underact-cli log columns\" prints all of them."
                                               : ". Did you mean \"" + nearest + "\"?"),
                          {{}, 0, 0, path}});
    } else if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(at), names[at]) !=
               names.begin() + static_cast<std::ptrdiff_t>(at)) {
      problems.push_back({"This column appears twice.", {{}, 0, 0, path}});
    } else if (index != 0) {
      found.push_back(index);
    }
  }
  if (!problems.empty()) return problems;
  return found;
}

}  // namespace underact::serve
